// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/lesson_stages.h"

#include <algorithm>
#include <memory>
#include <set>

#include <QDialog>
#include <QDockWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSplitter>
#include <QTemporaryDir>
#include <QUndoStack>
#include <QtTest>

#include "core/case/parameters.h"
#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/lesson/lesson_pane.h"
#include "ui/plot/plot_group.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/plot_spec.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/runs_model.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_lesson_stages {

class TestLessonStages : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_lesson_stages"));
    }
    void init()
    {
        QSettings().clear();
        window_ = std::make_unique<MainWindow>();
        window_->resize(1400, 900);
        window_->show();
        window_->actions().lesson->trigger();
    }
    void cleanup() { window_.reset(); }

    void namesPlotsThatThereAre()
    {
        std::set<QString> names;
        for (const PlotSpec& spec : standardPlots()) names.insert(spec.name);
        for (const LessonStep& step : lessonSteps())
            for (const std::string& name : step.stage.plots)
                QVERIFY2(names.contains(QString::fromStdString(name)), name.c_str());
    }

    void eachStepShowsItsOwnRuns()
    {
        run(lessonSteps()[0].runs[0]);
        QCOMPARE(shown(), (std::set<int>{1}));
        QVERIFY(plot("spacing")->isVisible() && plot("energy")->isVisible());
        QVERIFY(!plot("pitch")->isVisible() && !window_->runView().spectrum()->isVisible());
        QCOMPARE(plot("spacing")->xAxis().range(), (PlotRange{0.0, 0.3e-3}));

        click("Next");
        QVERIFY(shown().empty());
        run(lessonSteps()[1].runs[0]);
        run(lessonSteps()[1].runs[1]);
        QCOMPARE(shown(), (std::set<int>{2, 3}));
        QVERIFY(!plot("energy")->isVisible());
        // 3.8 and 7 nm are told apart on this axis.
        QCOMPARE(plot("spacing")->yAxis().range(), (PlotRange{-5e-9, 20e-9}));
        QCOMPARE(plot("spacing")->xAxis().range(), (PlotRange{0.0, 0.5e-3}));

        click("Back");
        QCOMPARE(shown(), (std::set<int>{1}));
        QVERIFY(plot("energy")->isVisible());
        QVERIFY(!plot("spacing")->view().y);
        // What the reader tries belongs to the step.
        runNow();
        QCOMPARE(shown(), (std::set<int>{1, 4}));
        click("Next");
        QCOMPARE(shown(), (std::set<int>{2, 3}));
    }

    /// A run that is performed again takes the place of the former one, unless the reader wrote a note on that.
    void sameRunTakesThePlaceOfTheFormer()
    {
        const LessonRun& first = lessonSteps()[0].runs[0];
        run(first);
        run(first);
        QCOMPARE(window_->runs().count(), 1);
        QCOMPARE(shown(), (std::set<int>{2}));
        QCOMPARE(window_->runs().record(0).label, QStringLiteral("Fig. 10 (a)"));
        window_->runs().setData(window_->runs().index(0), QStringLiteral("keep"), RunsModel::NoteRole);
        run(first);
        QCOMPARE(window_->runs().count(), 2);
    }

    /// Side view, plots and spectrum of a stage share the height, at each size; what the reader set comes back.
    void sharesTheHeight()
    {
        RunView& view = window_->runView();
        window_->findChild<QDockWidget*>("lesson")->close();
        QVERIFY(!view.stage());
        view.splitter()->setSizes({0, 500, 100});
        const QList<int> own = view.splitter()->sizes();
        PlotStage stage;
        stage.plots << "spacing";
        stage.side = stage.spectrum = true;
        view.setStage(stage);
        for (const QSize& size : {QSize(1400, 900), QSize(1100, 640)}) {
            window_->resize(size);
            QCoreApplication::processEvents();
            for (const int height : view.splitter()->sizes())
                QVERIFY2(height >= view.splitter()->height() / 5, qPrintable(QString::number(height)));
        }
        window_->resize(1400, 900);
        QCoreApplication::processEvents();
        view.setStage(std::nullopt);
        QCOMPARE(view.splitter()->sizes(), own);
    }

    /// What a step made it can make again; the parts have the sizes that the reader gave them.
    void theWindowClosesWithoutAQuestion()
    {
        RunView& view = window_->runView();
        window_->findChild<QDockWidget*>("lesson")->close();
        view.splitter()->setSizes({0, 500, 100});
        const QByteArray own = view.splitter()->saveState();
        window_->actions().lesson->trigger();
        run(lessonSteps()[0].runs[0]);
        Case tried = window_->edits().value();
        tried.initial.flyingHeight = 30e-9;
        window_->edits().setAll(tried, "tried");
        QVERIFY(!window_->close()); // the reader's own value
        for (QDialog* question : window_->findChildren<QDialog*>()) question->reject();
        window_->edits().undoStack().undo();
        QVERIFY(window_->close());
        QCOMPARE(QSettings().value("window/parts").toByteArray(), own);
    }

    void closingItEndsTheStage()
    {
        run(lessonSteps()[0].runs[0]);
        auto* dock = window_->findChild<QDockWidget*>("lesson");
        dock->close();
        QVERIFY(!window_->runView().stage());
        QVERIFY(plot("pitch")->isVisible() && window_->runView().spectrum()->isVisible());
        window_->actions().lesson->trigger();
        QVERIFY(window_->runView().stage());
        QVERIFY(!plot("pitch")->isVisible());
    }

    /// A reader's own runs come back, and a zoom does not stay.
    void leavesTheReadersOwnWork()
    {
        window_->findChild<QDockWidget*>("lesson")->close();
        runNow();
        QCOMPARE(shown(), (std::set<int>{1}));
        window_->actions().lesson->trigger();
        QVERIFY(shown().empty());
        run(lessonSteps()[0].runs[0]);
        QCOMPARE(shown(), (std::set<int>{2}));
        PlotGroup* group = window_->runView().plots()->group();
        group->setFollow(PlotGroup::Follow::Frozen); // as after a zoom
        click("Next");
        QCOMPARE(group->follow(), PlotGroup::Follow::WholeRun);
        run(lessonSteps()[1].runs[0]);
        QCOMPARE(plot("spacing")->xAxis().range(), (PlotRange{0.0, 0.5e-3}));
        window_->findChild<QDockWidget*>("lesson")->close();
        QCOMPARE(shown(), (std::set<int>{1}));
        // Another case ends the stage, too.
        window_->actions().lesson->trigger();
        window_->files().openNow("fig12a");
        QVERIFY(!window_->runView().stage());
    }

    /// Work in a file of the reader's own is asked about.
    void asksAboutAFileOfTheReader()
    {
        const QTemporaryDir folder;
        run(lessonSteps()[0].runs[0]);
        QCOMPARE(window_->files().write(folder.filePath("mine.toml")), QString());
        window_->edits().enter(*findParameter("initial.flying_height"), "50");
        window_->performLessonRun(lessonSteps()[0].runs[1]);
        auto* box = window_->findChild<QMessageBox*>("unsavedChanges");
        QVERIFY(box);
        box->button(QMessageBox::Cancel)->click();
        QCOMPARE(window_->edits().value().initial.flyingHeight, 50e-9);
    }

    void opensAtTheLastStep()
    {
        click("Next");
        click("Next");
        window_ = std::make_unique<MainWindow>();
        window_->show();
        window_->actions().lesson->trigger();
        QCOMPARE(window_->findChild<LessonPane*>()->step(), std::size_t(2));
        QSettings().setValue("lesson/step", 99); // of a longer lesson
        window_ = std::make_unique<MainWindow>();
        window_->actions().lesson->trigger();
        QCOMPARE(window_->findChild<LessonPane*>()->step(), lessonSteps().size() - 1);
    }

    void doesNotAskAboutWhatTheReaderTried()
    {
        run(lessonSteps()[0].runs[0]);
        window_->edits().enter(*findParameter("initial.flying_height"), "50");
        runNow();
        run(lessonSteps()[0].runs[1]);
        QVERIFY(!window_->findChild<QMessageBox*>("unsavedChanges"));
        QCOMPARE(window_->runs().count(), 3);
    }

private:
    PlotWidget* plot(const char* name) { return window_->runView().plots()->plot(QString::fromUtf8(name)); }
    void click(const char* name)
    {
        namedWidget<QPushButton>(*window_->findChild<LessonPane*>(), QString::fromUtf8(name))->click();
    }
    std::set<int> shown()
    {
        std::set<int> numbers;
        for (int row = 0; row < window_->runs().count(); ++row)
            if (window_->runs().record(row).shown) numbers.insert(window_->runs().record(row).number);
        return numbers;
    }
    void run(const LessonRun& what)
    {
        QSignalSpy ended(window_.get(), &MainWindow::calculationEnded);
        window_->performLessonRun(what);
        QVERIFY(!ended.isEmpty() || ended.wait(30000));
    }
    void runNow()
    {
        QSignalSpy ended(window_.get(), &MainWindow::calculationEnded);
        window_->startRun();
        QVERIFY(!ended.isEmpty() || ended.wait(30000));
    }

    std::unique_ptr<MainWindow> window_;
};

TOUCHDOWN_TEST(TestLessonStages)

} // namespace test_lesson_stages

#include "test_lesson_stages.moc"
