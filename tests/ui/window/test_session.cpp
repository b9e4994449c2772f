// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a window keeps of its work, and what the next one makes of it. A window that is destroyed without being closed
// leaves its folder as a kill does.
#include "ui/window/session.h"

#include <chrono>
#include <thread>

#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/results/results_reader.h"
#include "core/studies/study/study_file_reader.h"
#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"
#include "tests/ui/sample_study.h"
#include "tests/ui/window/window_session.h"
#include "ui/case/case_edits.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/modes_page.h"
#include "ui/film/series_page.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_window.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_session {

class TestSession : public QObject, test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase() { useNames("test_session"); }
    void init() { begin(); }
    void cleanup() { end(); }
    void keepsAnEditWithinASecond();
    void restoresTheCaseWithItsEdits();
    void restoresACaseWithItsFile();
    void restoresRuns();
    void marksAnInterruptedRun();
    void restoresSolutions();
    void restoresAStudy();
    void restoresTheSeriesAndTheModes();
    void restoresTheTextsOfStudies();
    void keepsWhatAStudyUnderWayHasFound();
    void deletesTheFileOfADeletedRun();
    void keepsARunWhoseOwnFileFails();
    void keepsARunWhoseOwnFileFailsLater();

private:
    void slowRun()
    {
        QComboBox* pace = window_->actions().pace;
        pace->setCurrentIndex(pace->findData(1e-5));
        window_->startRun();
    }
};

void TestSession::keepsAnEditWithinASecond()
{
    start();
    edit("springs.flying_height", QStringLiteral("4"));
    const QString folder = onlyFolder();
    const auto kept = [&folder] { return readSession(folder); };
    QTRY_VERIFY_WITH_TIMEOUT(kept().edited.text.contains(QStringLiteral("\"4 nm\"")), 1000);
    QVERIFY(!kept().closed);
    edit("springs.flying_height", QStringLiteral("5"));
    QTRY_VERIFY_WITH_TIMEOUT(kept().edited.text.contains(QStringLiteral("\"5 nm\"")), 1000);
}

void TestSession::restoresTheCaseWithItsEdits()
{
    start(true, QStringLiteral("fig11a"));
    edit("springs.flying_height", QStringLiteral("4"));
    edit("slider.mass", QStringLiteral("1 nm")); // no mass
    window_->setPage(MainWindow::Page::Studies);
    const Case edited = window_->edits().value();
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("the case fig11a with its edits")), qPrintable(offered()));
    restore();
    QCOMPARE(window_->files().sample(), QStringLiteral("fig11a"));
    QVERIFY(window_->files().modified());
    QVERIFY(window_->isWindowModified());
    QVERIFY(window_->edits().value() == edited);
    QCOMPARE(window_->edits().badEntry(*findParameter("slider.mass"))->text, QStringLiteral("1 nm"));
    QCOMPARE(window_->page()->property("currentIndex").toInt(), static_cast<int>(MainWindow::Page::Studies));
    while (window_->edits().undoStack().canUndo()) window_->actions().undo->trigger();
    QVERIFY(!window_->files().modified());
    QVERIFY(window_->edits().value() == openCase("fig11a").value);
    QCOMPARE(SessionFolder::all().size(), 1); // that of this window
}

void TestSession::restoresACaseWithItsFile()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mine.toml"));
    QCOMPARE(writeCaseFile(file.toStdString(), "# my slider\n[springs]\nflying_height = \"7 nm\" # as designed\n"),
             std::string());
    start();
    window_->files().openNow(file);
    edit("springs.flying_height", QStringLiteral("4"));
    kill();
    start();
    restore();
    QCOMPARE(window_->files().file(), file);
    window_->actions().save->trigger();
    QVERIFY(!window_->files().modified());
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    QVERIFY(written.readAll().startsWith("# my slider\n[springs]\nflying_height = \"4 nm\" # as designed\n"));
}

void TestSession::restoresRuns()
{
    start();
    run();
    run();
    run();
    window_->runs().setData(window_->runs().index(2), QStringLiteral("the best"), RunsModel::NoteRole);
    window_->runs().remove(0);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mine.h5"));
    QCOMPARE(saveHdf5(window_->runs().record(0), file), QString());
    window_->runs().setFile(2, file);
    const SampleBatch samples = window_->runs().record(1).samples(0);
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("2 runs.")), qPrintable(offered()));
    restore();
    QCOMPARE(window_->runs().count(), 2);
    QCOMPARE(window_->runs().record(0).number, 2);
    QCOMPARE(window_->runs().record(0).file, file); // it is saved
    const RunRecord& last = window_->runs().record(1);
    QCOMPARE(last.number, 3);
    QVERIFY(last.file.isEmpty());
    QCOMPARE(last.note, QStringLiteral("the best"));
    QCOMPARE(last.samples(0).time, samples.time);
    QCOMPARE(last.samples(0).columns, samples.columns);
    QCOMPARE(last.summary->status, RunStatus::Completed);
    QVERIFY(!last.interrupted);
    // It is work of this session now.
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("2 runs.")), qPrintable(offered()));
    restore();
    QCOMPARE(window_->runs().record(1).samples(0).columns, samples.columns);
}

void TestSession::marksAnInterruptedRun()
{
    start();
    slowRun();
    const QString file = onlyFolder() + QStringLiteral("/run1.h5");
    QTRY_VERIFY(QFileInfo::exists(file));
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("1 run, which was interrupted")), qPrintable(offered()));
    restore();
    QVERIFY(window_->runs().record(0).interrupted);
    QVERIFY(window_->runs().record(0).sampleCount() > 1);
    QCOMPARE(window_->runs().index(0).data(RunsModel::ResultRole).toString(), QStringLiteral("interrupted"));
}

void TestSession::restoresSolutions()
{
    start();
    window_->film().solutions().add(test::sampleFilmCase(), test::sampleSteady());
    Case other = test::sampleFilmCase();
    other.title = "Another plane";
    window_->film().solutions().add(other, test::sampleSteady());
    window_->film().solutions().remove(0);
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("1 static solution.")), qPrintable(offered()));
    restore();
    const SolutionsModel& solutions = window_->film().solutions();
    QCOMPARE(solutions.count(), 1);
    QCOMPARE(solutions.record(0).name, QStringLiteral("Another plane"));
    QVERIFY(solutions.record(0).file.isEmpty());
    QCOMPARE(solutions.record(0).result.pressure, test::sampleSteady().pressure);
    QCOMPARE(window_->files().sample(), QStringLiteral("fig10a")); // the case is not that of the solution
}

void TestSession::restoresAStudy()
{
    start();
    window_->studies().restore({sampleReport(), "", "", ""});
    emit window_->studies().ended(sampleReport());
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("1 study report.")), qPrintable(offered()));
    restore();
    const StudyOutcome* outcome = window_->studies().outcome("work-precision");
    QVERIFY(outcome && outcome->report);
    QCOMPARE(outcome->report->findings, sampleReport().findings);
    QVERIFY(!outcome->file.holds());
}

void TestSession::restoresTheSeriesAndTheModes()
{
    start();
    const FilmView* view = window_->film().view();
    Case listed = test::sampleFilmCase();
    listed.steady.radii = {20e-3, 25e-3};
    view->series()->restore({listed, {test::sampleSteady()}, {}});
    FoundModes modes{test::sampleFilmCase(), {}};
    modes.result.modes.resize(1);
    modes.result.modes.front().frequency = 91.5e3;
    modes.result.modes.front().kind = "pitch";
    view->modes()->restore(modes);
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("1 series of static states, modes.")), qPrintable(offered()));
    restore();
    const SeriesPage& series = *window_->film().view()->series();
    QCOMPARE(series.states().size(), std::size_t(1));
    QCOMPARE(series.states().front().point.radius, 20e-3);
    QCOMPARE(series.states().front().result.minimumSpacing, test::sampleSteady().minimumSpacing);
    QCOMPARE(series.unsaved(), std::size_t(1));
    const std::optional<FoundModes> found = window_->film().view()->modes()->known();
    QVERIFY(found);
    QCOMPARE(found->result.modes.front().frequency, 91.5e3);
    // They are work of this window now.
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("1 series of static states, modes.")), qPrintable(offered()));
    // Another case has no series.
    restore();
    window_->files().leaveUnsaved();
    window_->files().openNow(QStringLiteral("fig12a"));
    kill();
    start();
    QVERIFY2(offered().isEmpty(), qPrintable(offered()));
}

void TestSession::restoresTheTextsOfStudies()
{
    const QString file = data_->filePath(QStringLiteral("mine.toml"));
    QCOMPARE(writeCaseFile(file.toStdString(), "kind = \"hysteresis\"\ncase = \"fig10a\"\nsteps = 400\n"),
             std::string());
    start();
    StudyEditor& editor = *window_->studies().editor();
    window_->openStudy(file);
    editor.setText(QStringLiteral("kind = \"hysteresis\"\nsteps = 123\n"));
    editor.setKind(QStringLiteral("cycles"));
    editor.setText(QStringLiteral("kind = \"cycles\"\ncase = \"fig12a\"\n"));
    const QString folder = onlyFolder();
    QTRY_COMPARE(readSession(folder).drafts.size(), std::size_t(2));
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("the edited texts of 2 studies")), qPrintable(offered()));
    restore();
    StudyEditor& again = *window_->studies().editor();
    QCOMPARE(again.kind(), QStringLiteral("cycles"));
    QCOMPARE(again.toText(), QStringLiteral("kind = \"cycles\"\ncase = \"fig12a\"\n"));
    again.setKind(QStringLiteral("hysteresis"));
    QCOMPARE(again.toText(), QStringLiteral("kind = \"hysteresis\"\nsteps = 123\n"));
    QCOMPARE(again.unsaved().size(), std::size_t(2));
    QCOMPARE(again.unsaved().back().file, file);
    // A text that is as its file has it is nothing to restore.
    QCOMPARE(again.save(file), QString());
    QCOMPARE(again.unsaved().size(), std::size_t(1));
}

void TestSession::keepsWhatAStudyUnderWayHasFound()
{
    // A study that shows a part of its report and lasts until it is stopped.
    StudyCatalogue catalogue = coreStudies();
    catalogue.plan = [](const std::string& kind, const std::string& text, const std::string&,
                        const std::filesystem::path&, const Case& c) {
        StudyPlan plan;
        plan.kind = kind;
        plan.text = text;
        plan.start.value = c;
        plan.perform = [kind](int, const StudyCallback& callback) {
            StudyReport part = sampleReport();
            part.kind = kind;
            callback({0.5, "half of it", &part});
            while (callback({0.5, "half of it", nullptr})) std::this_thread::sleep_for(std::chrono::milliseconds(10));
            part.status = StudyStatus::Cancelled;
            return part;
        };
        return plan;
    };
    window_ = std::make_unique<MainWindow>(catalogue);
    window_->files().openNow(QStringLiteral("fig10a"));
    window_->beginSession(false);
    window_->studies().editor()->setKind(QStringLiteral("hysteresis"));
    window_->performStudy();
    const QString file = onlyFolder() + QStringLiteral("/study-hysteresis.h5");
    QTRY_VERIFY(QFileInfo::exists(file));
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("1 study, interrupted")), qPrintable(offered()));
    restore();
    const StudyOutcome* outcome = window_->studies().outcome("hysteresis");
    QVERIFY(outcome && outcome->report);
    QCOMPARE(outcome->report->tables.size(), sampleReport().tables.size());
    QVERIFY(outcome->report->findings.empty()); // of a part they could be wrong
    QCOMPARE(outcome->report->status, StudyStatus::Interrupted);
    QVERIFY(outcome->report->message.find("interrupted") != std::string::npos);
}

void TestSession::deletesTheFileOfADeletedRun()
{
    start();
    run();
    const QString file = onlyFolder() + QStringLiteral("/run1.h5");
    QTRY_COMPARE(window_->runs().record(0).kept, file);
    window_->runs().remove(0);
    QTRY_VERIFY(!QFileInfo::exists(file));
}

/// The user records to a file that cannot be written: the session has the run instead.
void TestSession::keepsARunWhoseOwnFileFails()
{
    start();
    window_->runWindow().start({window_->edits().value(), window_->files().text(), "/no/such/folder/run.h5"});
    QTRY_VERIFY(!window_->controller().active());
    QVERIFY(window_->runs().record(0).file.isEmpty());
    const QString file = onlyFolder() + QStringLiteral("/run1.h5");
    QTRY_COMPARE(window_->runs().record(0).kept, file);
    QCOMPARE(readResults(file.toStdString()).samples.size(), window_->runs().record(0).sampleCount());
}

/// Its samples until then come from memory.
void TestSession::keepsARunWhoseOwnFileFailsLater()
{
    start();
    const std::string own = data_->filePath(QStringLiteral("own.h5")).toStdString();
    QComboBox* pace = window_->actions().pace;
    pace->setCurrentIndex(pace->findData(1e-5));
    window_->runWindow().start({window_->edits().value(), window_->files().text(), own});
    QTRY_VERIFY(window_->runs().record(0).sampleCount() > 1);
    emit window_->controller().recordingFailed(1, QStringLiteral("the disk is full"));
    window_->controller().stopAndWait();
    const QString file = onlyFolder() + QStringLiteral("/run1.h5");
    QTRY_COMPARE(window_->runs().record(0).kept, file);
    QCOMPARE(readResults(file.toStdString()).samples.time, window_->runs().record(0).samples(0).time);
}

TOUCHDOWN_TEST(TestSession)

} // namespace test_session

#include "test_session.moc"
