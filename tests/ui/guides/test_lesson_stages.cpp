// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/lesson_stages.h"

#include <algorithm>
#include <memory>
#include <set>

#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSplitter>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case/parameters.h"
#include "tests/support/test_program.h"
#include "tests/ui/fake_workbench.h"
#include "tests/ui/named_widget.h"
#include "ui/guides/guides.h"
#include "ui/guides/lesson_pane.h"
#include "ui/plot/plot_group.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/plot_spec.h"
#include "ui/runs/side_view.h"

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
        open();
    }
    void cleanup() { close(); }

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
        QVERIFY(!plot("pitch")->isVisible() && !bench_->runView().spectrum()->isVisible());
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
        QCOMPARE(bench_->runs().count(), 1);
        QCOMPARE(shown(), (std::set<int>{2}));
        QCOMPARE(bench_->runs().record(0).label, QStringLiteral("Fig. 10 (a)"));
        bench_->runs().setData(bench_->runs().index(0), QStringLiteral("keep"), RunsModel::NoteRole);
        run(first);
        QCOMPARE(bench_->runs().count(), 2);
    }

    /// Side view, plots and spectrum of a stage share the height, at each size; what the reader set comes back.
    void sharesTheHeight()
    {
        RunView& view = bench_->runView();
        toggle(false);
        QVERIFY(!view.stage());
        view.splitter()->setSizes({0, 500, 100});
        const QList<int> own = view.splitter()->sizes();
        PlotStage stage;
        stage.plots << "spacing";
        stage.side = stage.spectrum = true;
        view.setStage(stage);
        for (const QSize& size : {QSize(1400, 900), QSize(1100, 640)}) {
            bench_->window().resize(size);
            QCoreApplication::processEvents();
            for (const int height : view.splitter()->sizes())
                QVERIFY2(height >= view.splitter()->height() / 5, qPrintable(QString::number(height)));
        }
        bench_->window().resize(1400, 900);
        QCoreApplication::processEvents();
        view.setStage(std::nullopt);
        QCOMPARE(view.splitter()->sizes(), own);
    }

    /// Where letters are large for the place, the plots have it; the side view has its own page.
    void plotsComeBeforeTheSideView()
    {
        RunsModel runs;
        RunView view(runs);
        PlotStage stage;
        stage.plots << "spacing"
                    << "energy";
        stage.side = true;
        view.show();
        view.setStage(stage);
        int height = 900;
        for (const int letters : {12, 36, 12}) { // [px]
            QFont font = view.font();
            font.setPixelSize(letters);
            view.setFont(font);
            view.resize(900, height++);
            QTRY_COMPARE(view.sideAbove()->isVisible(), letters == 12);
            view.setCase({}); // as by an edit
            QCOMPARE(view.sideAbove()->isVisible(), letters == 12);
            QVERIFY(view.plots()->isVisible());
        }
    }

    void closingItEndsTheStage()
    {
        run(lessonSteps()[0].runs[0]);
        toggle(false);
        QVERIFY(!bench_->runView().stage());
        QVERIFY(plot("pitch")->isVisible() && bench_->runView().spectrum()->isVisible());
        guides_->open(LessonPane::Kind::Lesson);
        QVERIFY(bench_->runView().stage());
        QVERIFY(!plot("pitch")->isVisible());
    }

    /// A reader's own runs come back, and a zoom does not stay.
    void leavesTheReadersOwnWork()
    {
        toggle(false);
        runNow();
        QCOMPARE(shown(), (std::set<int>{1}));
        guides_->open(LessonPane::Kind::Lesson);
        QVERIFY(shown().empty());
        run(lessonSteps()[0].runs[0]);
        QCOMPARE(shown(), (std::set<int>{2}));
        PlotGroup* group = bench_->runView().plots()->group();
        group->setFollow(PlotGroup::Follow::Frozen); // as after a zoom
        click("Next");
        QCOMPARE(group->follow(), PlotGroup::Follow::WholeRun);
        run(lessonSteps()[1].runs[0]);
        QCOMPARE(plot("spacing")->xAxis().range(), (PlotRange{0.0, 0.5e-3}));
        toggle(false);
        QCOMPARE(shown(), (std::set<int>{1}));
        // Another case ends the stage, too.
        guides_->open(LessonPane::Kind::Lesson);
        bench_->files().openNow("fig12a");
        QVERIFY(!bench_->runView().stage());
    }

    /// Work in a file of the reader's own is asked about.
    void asksAboutAFileOfTheReader()
    {
        const QTemporaryDir folder;
        run(lessonSteps()[0].runs[0]);
        QCOMPARE(bench_->files().write(folder.filePath("mine.toml")), QString());
        bench_->edits().enter(*findParameter("initial.flying_height"), "50");
        guides_->perform(lessonSteps()[0].runs[1]);
        auto* box = bench_->window().findChild<QMessageBox*>("unsavedChanges");
        QVERIFY(box);
        box->button(QMessageBox::Cancel)->click();
        QCOMPARE(bench_->edits().value().initial.flyingHeight, 50e-9);
    }

    void opensAtTheLastStep()
    {
        click("Next");
        click("Next");
        open();
        QCOMPARE(pane().step(), std::size_t(2));
        QSettings().setValue("lesson/step", 99); // of a longer lesson
        open();
        QCOMPARE(pane().step(), lessonSteps().size() - 1);
    }

    void doesNotAskAboutWhatTheReaderTried()
    {
        run(lessonSteps()[0].runs[0]);
        bench_->edits().enter(*findParameter("initial.flying_height"), "50");
        runNow();
        run(lessonSteps()[0].runs[1]);
        QVERIFY(!bench_->window().findChild<QMessageBox*>("unsavedChanges"));
        QCOMPARE(bench_->runs().count(), 3);
    }

private:
    PlotWidget* plot(const char* name) { return bench_->runView().plots()->plot(QString::fromUtf8(name)); }
    void click(const char* name) { namedWidget<QPushButton>(pane(), QString::fromUtf8(name))->click(); }
    std::set<int> shown()
    {
        std::set<int> numbers;
        for (int row = 0; row < bench_->runs().count(); ++row)
            if (bench_->runs().record(row).shown) numbers.insert(bench_->runs().record(row).number);
        return numbers;
    }
    void run(const LessonRun& what)
    {
        const QSignalSpy ended(&bench_->runWindow(), &RunWindow::ended);
        guides_->perform(what);
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 30'000);
    }
    void runNow() { bench_->runToEnd(); }
    LessonPane& pane() { return *guides_->pane(LessonPane::Kind::Lesson); }
    /// As the reader opens and closes its pane.
    void toggle(bool open) { guides_->toggle(&pane(), open); }
    void open()
    {
        close();
        bench_ = std::make_unique<test::FakeWorkbench>();
        bench_->window().resize(1400, 900);
        bench_->window().show();
        guides_ = std::make_unique<Guides>(*bench_, bench_->window());
        guides_->open(LessonPane::Kind::Lesson);
    }
    void close()
    {
        guides_.reset();
        bench_.reset();
    }

    std::unique_ptr<test::FakeWorkbench> bench_;
    std::unique_ptr<Guides> guides_;
};

TOUCHDOWN_TEST(TestLessonStages)

} // namespace test_lesson_stages

#include "test_lesson_stages.moc"
