// SPDX-License-Identifier: GPL-3.0-or-later
//
// A case that is opened takes the series and the modes of the one before it away: the window asks first.
#include <QDropEvent>
#include <QFileDialog>
#include <QMimeData>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/case/case_panel.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/modes_page.h"
#include "ui/film/series_page.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_another_case {

class TestAnotherCase : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_another_case"));
    }
    void init()
    {
        QSettings().clear();
        window_ = std::make_unique<MainWindow>();
        window_->files().openNow(QStringLiteral("fig10a"));
        window_->show();
        file_ = folder_.filePath(QStringLiteral("other.toml"));
        QCOMPARE(writeCaseFile(file_.toStdString(), "title = \"other\"\n"), std::string());
    }
    void cleanup() { window_.reset(); }
    void asksByEachWay_data()
    {
        QTest::addColumn<QString>("way");
        for (const char* way : {"open", "new", "drop", "sample", "preset", "recent", "result", "first steps"})
            QTest::newRow(way) << way;
    }
    void asksByEachWay()
    {
        QFETCH(const QString, way);
        if (way == "recent") {
            window_->files().openNow(file_);
            window_->files().openNow(QStringLiteral("fig10a"));
        }
        addSeries();
        addModes();
        if (way == "open") window_->files().open(file_);
        if (way == "new") window_->files().newCase();
        if (way == "drop") drop();
        if (way == "sample") emit window_->actions().sampleChosen(QStringLiteral("fig12a"));
        if (way == "preset") emit window_->casePanel().presetChosen(QStringLiteral("fig12a"));
        if (way == "recent") {
            emit window_->actions().recent->aboutToShow();
            window_->actions().recent->actions().front()->trigger();
        }
        if (way == "result") window_->files().use(test::sampleFilmCase(), QStringLiteral("st.h5"), {});
        if (way == "first steps") window_->actions().firstSteps->trigger();
        QMessageBox* box = question(*window_, "anotherCase");
        QVERIFY(box);
        QVERIFY2(box->informativeText().contains(QStringLiteral("a series of 2 static states")),
                 qPrintable(box->informativeText()));
        QVERIFY(box->informativeText().contains(QStringLiteral("modes that are not saved")));
        answer(*window_, "anotherCase", QStringLiteral("Go on working"));
        QCOMPARE(window_->files().sample(), QStringLiteral("fig10a"));
        QCOMPARE(view().series()->unsaved(), std::size_t(2));
        QVERIFY(view().modes()->unsaved());
    }
    void opensWithoutSaving()
    {
        addSeries();
        window_->files().open(file_);
        answer(*window_, "anotherCase", QStringLiteral("Open without saving"));
        QCOMPARE(window_->files().file(), file_);
        QVERIFY(view().series()->states().empty());
    }
    void savesAllAndOpens()
    {
        const QTemporaryDir into;
        addSeries();
        addModes();
        window_->edits().enter(*findParameter("springs.flying_height"), QStringLiteral("4"));
        window_->files().open(file_);
        QVERIFY(question(*window_, "anotherCase")->informativeText().contains(QStringLiteral("the case “fig10a”")));
        const QByteArray numbers = view().series()->csv();
        answer(*window_, "anotherCase", QStringLiteral("Save all and open"));
        auto* dialog = window_->findChild<QFileDialog*>(QStringLiteral("saveAllFolder"));
        QVERIFY(dialog);
        dialog->setDirectory(into.path());
        dialog->selectFile(into.path());
        QMetaObject::invokeMethod(dialog, "accept");
        QCOMPARE(window_->files().file(), file_); // without a second question
        QFile series(into.filePath(QStringLiteral("series.csv")));
        QVERIFY(series.open(QIODevice::ReadOnly));
        QCOMPARE(series.readAll(), numbers);
        QVERIFY(QFileInfo::exists(into.filePath(QStringLiteral("modes.csv"))));
        QCOMPARE(openCase(into.filePath(QStringLiteral("fig10a.toml")).toStdString()).value.springs.flyingHeight, 4e-9);
    }
    void asksNothingOfWhatIsSaved()
    {
        const QTemporaryDir into;
        addSeries();
        addModes();
        QCOMPARE(view().series()->save(into.filePath(QStringLiteral("series.csv"))), QString());
        QCOMPARE(view().modes()->save(into.filePath(QStringLiteral("modes.csv"))), QString());
        window_->files().open(file_);
        QVERIFY(!question(*window_, "anotherCase"));
        QCOMPARE(window_->files().file(), file_);
    }
    /// A run or a solution of these values brings them back; who has a file wants them in it.
    void asksForChangesThatNoResultHas_data()
    {
        QTest::addColumn<QString>("source");
        QTest::addColumn<QString>("result");
        QTest::addColumn<bool>("asks");
        QTest::newRow("a sample, a run") << "fig10a"
                                         << "run" << false;
        QTest::newRow("a sample, a solution") << "fig10a"
                                              << "solution" << false;
        QTest::newRow("a sample, nothing") << "fig10a"
                                           << "" << true;
        QTest::newRow("a sample, other values") << "fig10a"
                                                << "other" << true;
        QTest::newRow("a sample, a wrong entry") << "fig10a"
                                                 << "wrong" << true;
        QTest::newRow("a file, a run") << file_ << "run" << true;
    }
    void asksForChangesThatNoResultHas()
    {
        QFETCH(const QString, source);
        QFETCH(const QString, result);
        QFETCH(const bool, asks);
        window_->files().openNow(source);
        const auto enter = [&](const char* key, const char* text) {
            window_->edits().enter(*findParameter(key), QString::fromLatin1(text));
        };
        enter("run.duration", "10 us");
        enter("springs.flying_height", "4");
        if (result == "solution")
            window_->film().solutions().add(window_->edits().value(), test::sampleSteady());
        else if (!result.isEmpty()) {
            window_->startRun();
            QTRY_VERIFY(!window_->controller().active());
        }
        if (result == "other") enter("springs.flying_height", "5");
        if (result == "wrong") enter("springs.flying_height", "much");
        QVERIFY(window_->isWindowModified());
        window_->files().open(QStringLiteral("fig12a"));
        QCOMPARE(question(*window_, "unsavedChanges") != nullptr, asks);
        QCOMPARE(window_->files().sample() == QStringLiteral("fig12a"), !asks);
    }
    /// Runs, solutions and studies stay.
    void asksNothingOfWhatStays()
    {
        window_->film().solutions().add(test::sampleFilmCase(), test::sampleSteady());
        window_->files().open(file_);
        QVERIFY(!question(*window_, "anotherCase"));
        QCOMPARE(window_->film().solutions().count(), 1);
    }

private:
    const FilmView& view() { return *window_->film().view(); }
    void addSeries()
    {
        Case listed = test::sampleFilmCase();
        listed.steady.radii = {20e-3, 25e-3};
        view().series()->restore({listed, {test::sampleSteady(), test::sampleSteady()}, {}});
    }
    void addModes()
    {
        FoundModes modes{test::sampleFilmCase(), {}};
        modes.result.modes.resize(1);
        view().modes()->restore(modes);
    }
    void drop()
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(file_)});
        QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(window_.get(), &enter);
        QDropEvent event(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window_.get(), &event);
    }

    const QTemporaryDir folder_;
    QString file_;
    std::unique_ptr<MainWindow> window_;
};

TOUCHDOWN_TEST(TestAnotherCase)

} // namespace test_another_case

#include "test_another_case.moc"
