// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a session keeps of its work, and what the next one makes of it, without a window. A session that is destroyed
// without being closed leaves its folder as a kill does.
#include "ui/sessions/session.h"

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
#include "tests/ui/sessions/bench_session.h"
#include "ui/film/modes_page.h"
#include "ui/film/series_page.h"

using namespace touchdown;

namespace test_session {

class TestSession : public QObject, test::BenchSession {
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
    start(QStringLiteral("fig11a"));
    edit("springs.flying_height", QStringLiteral("4"));
    edit("slider.mass", QStringLiteral("1 nm")); // no mass
    bench_->setPage(Workbench::Page::Studies);
    const Case edited = bench_->edits().value();
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("the case fig11a with its edits")), qPrintable(offered()));
    restore();
    QCOMPARE(bench_->files().sample(), QStringLiteral("fig11a"));
    QVERIFY(bench_->files().modified());
    QVERIFY(bench_->edits().value() == edited);
    QCOMPARE(bench_->edits().badEntry(*findParameter("slider.mass"))->text, QStringLiteral("1 nm"));
    QCOMPARE(bench_->shownPage(), Workbench::Page::Studies);
    while (bench_->edits().undoStack().canUndo()) bench_->edits().undoStack().undo();
    QVERIFY(!bench_->files().modified());
    QVERIFY(bench_->edits().value() == openCase("fig11a").value);
    QCOMPARE(SessionFolder::all().size(), 1); // that of this session
}

void TestSession::restoresACaseWithItsFile()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mine.toml"));
    QCOMPARE(writeCaseFile(file.toStdString(), "# my slider\n[springs]\nflying_height = \"7 nm\" # as designed\n"),
             std::string());
    start();
    bench_->files().openNow(file);
    edit("springs.flying_height", QStringLiteral("4"));
    kill();
    start();
    restore();
    QCOMPARE(bench_->files().file(), file);
    bench_->files().save();
    QVERIFY(!bench_->files().modified());
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    QVERIFY(written.readAll().startsWith("# my slider\n[springs]\nflying_height = \"4 nm\" # as designed\n"));
}

void TestSession::restoresRuns()
{
    start();
    bench_->runToEnd();
    bench_->runToEnd();
    bench_->runToEnd();
    bench_->runs().setData(bench_->runs().index(2), QStringLiteral("the best"), RunsModel::NoteRole);
    bench_->runs().remove(0);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mine.h5"));
    QCOMPARE(saveHdf5(bench_->runs().record(0), file), QString());
    bench_->runs().setFile(2, file);
    const SampleBatch samples = bench_->runs().record(1).samples(0);
    kill();
    start();
    QCOMPARE(offered(), QStringLiteral("2 runs"));
    restore();
    QCOMPARE(bench_->runs().count(), 2);
    QCOMPARE(bench_->runs().record(0).number, 2);
    QCOMPARE(bench_->runs().record(0).file, file); // it is saved
    const RunRecord& last = bench_->runs().record(1);
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
    QCOMPARE(offered(), QStringLiteral("2 runs"));
    restore();
    QCOMPARE(bench_->runs().record(1).samples(0).columns, samples.columns);
}

void TestSession::marksAnInterruptedRun()
{
    start();
    bench_->controller().setPace(1e-5);
    bench_->startRun();
    const QString file = onlyFolder() + QStringLiteral("/run1.h5");
    QTRY_VERIFY(QFileInfo::exists(file));
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("1 run, which was interrupted")), qPrintable(offered()));
    restore();
    QVERIFY(bench_->runs().record(0).interrupted);
    QVERIFY(bench_->runs().record(0).sampleCount() > 1);
    QCOMPARE(bench_->runs().index(0).data(RunsModel::ResultRole).toString(), QStringLiteral("interrupted"));
}

void TestSession::restoresSolutions()
{
    start();
    bench_->film().solutions().add(test::sampleFilmCase(), test::sampleSteady());
    Case other = test::sampleFilmCase();
    other.title = "Another plane";
    bench_->film().solutions().add(other, test::sampleSteady());
    bench_->film().solutions().remove(0);
    kill();
    start();
    QCOMPARE(offered(), QStringLiteral("1 static solution"));
    restore();
    const SolutionsModel& solutions = bench_->film().solutions();
    QCOMPARE(solutions.count(), 1);
    QCOMPARE(solutions.record(0).name, QStringLiteral("Another plane"));
    QVERIFY(solutions.record(0).file.isEmpty());
    QCOMPARE(solutions.record(0).result.pressure, test::sampleSteady().pressure);
    QCOMPARE(bench_->files().sample(), QStringLiteral("fig10a")); // the case is not that of the solution
}

void TestSession::restoresAStudy()
{
    start();
    bench_->studies().restore({sampleReport(), "", "", ""});
    emit bench_->studies().ended(sampleReport());
    kill();
    start();
    QCOMPARE(offered(), QStringLiteral("1 study report"));
    restore();
    const StudyOutcome* outcome = bench_->studies().outcome("work-precision");
    QVERIFY(outcome && outcome->report);
    QCOMPARE(outcome->report->findings, sampleReport().findings);
    QVERIFY(!outcome->file.holds());
}

void TestSession::restoresTheSeriesAndTheModes()
{
    start();
    const FilmView* view = bench_->film().view();
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
    QCOMPARE(offered(), QStringLiteral("1 series of static states, modes"));
    restore();
    const SeriesPage& series = *bench_->film().view()->series();
    QCOMPARE(series.states().size(), std::size_t(1));
    QCOMPARE(series.states().front().point.radius, 20e-3);
    QCOMPARE(series.states().front().result.minimumSpacing, test::sampleSteady().minimumSpacing);
    QCOMPARE(series.unsaved(), std::size_t(1));
    const std::optional<FoundModes> found = bench_->film().view()->modes()->known();
    QVERIFY(found);
    QCOMPARE(found->result.modes.front().frequency, 91.5e3);
    // They are work of this window now.
    kill();
    start();
    QCOMPARE(offered(), QStringLiteral("1 series of static states, modes"));
    // Another case has no series.
    restore();
    bench_->files().leaveUnsaved();
    bench_->files().openNow(QStringLiteral("fig12a"));
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
    StudyEditor& editor = *bench_->studies().editor();
    QCOMPARE(editor.open(file), QString());
    editor.setText(QStringLiteral("kind = \"hysteresis\"\nsteps = 123\n"));
    editor.setKind(QStringLiteral("cycles"));
    editor.setText(QStringLiteral("kind = \"cycles\"\ncase = \"fig12a\"\n"));
    const QString folder = onlyFolder();
    QTRY_COMPARE(readSession(folder).drafts.size(), std::size_t(2));
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("the edited texts of 2 studies")), qPrintable(offered()));
    restore();
    StudyEditor& again = *bench_->studies().editor();
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
    start(QStringLiteral("fig10a"), catalogue);
    bench_->studies().editor()->setKind(QStringLiteral("hysteresis"));
    bench_->performStudy();
    const QString file = onlyFolder() + QStringLiteral("/study-hysteresis.h5");
    QTRY_VERIFY(QFileInfo::exists(file));
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("1 study, interrupted")), qPrintable(offered()));
    restore();
    const StudyOutcome* outcome = bench_->studies().outcome("hysteresis");
    QVERIFY(outcome && outcome->report);
    QCOMPARE(outcome->report->tables.size(), sampleReport().tables.size());
    QVERIFY(outcome->report->findings.empty()); // of a part they could be wrong
    QCOMPARE(outcome->report->status, StudyStatus::Interrupted);
    QVERIFY(outcome->report->message.find("interrupted") != std::string::npos);
}

void TestSession::deletesTheFileOfADeletedRun()
{
    start();
    bench_->runToEnd();
    const QString file = onlyFolder() + QStringLiteral("/run1.h5");
    QTRY_COMPARE(bench_->runs().record(0).kept, file);
    bench_->runs().remove(0);
    QTRY_VERIFY(!QFileInfo::exists(file));
}

/// The user records to a file that cannot be written: the session has the run instead.
void TestSession::keepsARunWhoseOwnFileFails()
{
    start();
    bench_->runWindow().start({bench_->edits().value(), bench_->files().text(), "/no/such/folder/run.h5"});
    QTRY_VERIFY(!bench_->controller().active());
    QVERIFY(bench_->runs().record(0).file.isEmpty());
    const QString file = onlyFolder() + QStringLiteral("/run1.h5");
    QTRY_COMPARE(bench_->runs().record(0).kept, file);
    QCOMPARE(readResults(file.toStdString()).samples.size(), bench_->runs().record(0).sampleCount());
}

/// Its samples until then come from memory.
void TestSession::keepsARunWhoseOwnFileFailsLater()
{
    start();
    const std::string own = data_->filePath(QStringLiteral("own.h5")).toStdString();
    bench_->controller().setPace(1e-5);
    bench_->runWindow().start({bench_->edits().value(), bench_->files().text(), own});
    QTRY_VERIFY(bench_->runs().record(0).sampleCount() > 1);
    emit bench_->controller().recordingFailed(1, QStringLiteral("the disk is full"));
    bench_->controller().stopAndWait();
    const QString file = onlyFolder() + QStringLiteral("/run1.h5");
    QTRY_COMPARE(bench_->runs().record(0).kept, file);
    QCOMPARE(readResults(file.toStdString()).samples.time, bench_->runs().record(0).samples(0).time);
}

TOUCHDOWN_TEST(TestSession)

} // namespace test_session

#include "test_session.moc"
