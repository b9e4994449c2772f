// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a window keeps of its work, and what the next one makes of it. A window that is destroyed without being closed
// leaves its folder as a kill does.
#include "ui/window/session.h"

#include <chrono>
#include <thread>

#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/results/results_reader.h"
#include "core/studies/study/study_file_reader.h"
#include "tests/support/file_size_limit.h"
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
#include "ui/sessions/session_offer.h"
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
    void asksAgainLater();
    void discards();
    void offersNothingWithoutWork();
    void leavesALiveSessionAlone();
    void asksNothingWhenACaseWasNamed();
    void deletesTheFileOfADeletedRun();
    void keepsARunWhoseOwnFileFails();
    void keepsARunWhoseOwnFileFailsLater();
    void endsWithoutATraceWhenAllIsSaved();
    void keepsTheNoteOfASavedRun();
    void bringsBackWhatWasClosedWithoutSaving();
    void startsWithTheDefaultCaseIfWanted();
    void removesTheOldestClosedSessions();
    void goesOnInMemoryWhenTheDiskIsFull();
    void saysAllTheTimeThatNothingIsKept();
    void keepsAllAgainWhenItsFolderWasRemoved();

private:
    void kill() { window_.reset(); }
    QString offered()
    {
        const QMessageBox* box = question(*window_, "restoreSession");
        return box ? box->informativeText() : QString();
    }
    void edit(const char* key, const QString& text) { window_->edits().enter(*findParameter(key), text); }
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
    QVERIFY(outcome->file.isEmpty());
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
    QCOMPARE(outcome->report->findings, sampleReport().findings);
    QCOMPARE(outcome->report->status, StudyStatus::Cancelled);
    QVERIFY(outcome->report->message.find("interrupted") != std::string::npos);
}

void TestSession::asksAgainLater()
{
    start();
    run();
    kill();
    start();
    answer(*window_, "restoreSession", QStringLiteral("Later"));
    QCOMPARE(window_->runs().count(), 0);
    kill();
    start();
    QVERIFY(offered().contains(QStringLiteral("1 run.")));
}

void TestSession::discards()
{
    start();
    run();
    kill();
    start();
    answer(*window_, "restoreSession", QStringLiteral("Discard"));
    QCOMPARE(window_->runs().count(), 0);
    QCOMPARE(SessionFolder::all().size(), 1); // that of this window
}

void TestSession::offersNothingWithoutWork()
{
    start();
    kill();
    start();
    QVERIFY(offered().isEmpty());
    QCOMPARE(SessionFolder::all().size(), 1);
}

void TestSession::leavesALiveSessionAlone()
{
    start();
    run();
    const std::unique_ptr<MainWindow> first = std::move(window_);
    start();
    QVERIFY(offered().isEmpty());
    QCOMPARE(SessionFolder::all().size(), 2);
    QVERIFY(SessionFolder::ended().isEmpty());
    // Nor are its files removed, whatever they take.
    keepSessionsWithin(1);
    QCOMPARE(SessionFolder::all().size(), 2);
}

void TestSession::asksNothingWhenACaseWasNamed()
{
    start();
    run();
    kill();
    start(false);
    QVERIFY(offered().isEmpty());
    kill();
    start();
    QVERIFY(offered().contains(QStringLiteral("1 run.")));
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

void TestSession::endsWithoutATraceWhenAllIsSaved()
{
    start();
    run();
    window_->runs().setFile(1, QStringLiteral("mine.h5"));
    window_->close();
    QVERIFY(!window_->isVisible());
    QVERIFY(SessionFolder::all().isEmpty());
}

/// A results file has no place for it.
void TestSession::keepsTheNoteOfASavedRun()
{
    start();
    run();
    const QString file = data_->filePath(QStringLiteral("mine.h5"));
    RunsModel& runs = window_->runs();
    QCOMPARE(saveHdf5(runs.record(0), file), QString());
    runs.setFile(1, file);
    runs.setData(runs.index(0), QStringLiteral("the best"), RecordList::NoteRole);
    window_->close();
    QVERIFY(!window_->isVisible()); // without a question
    QCOMPARE(SessionFolder::all().size(), 1);
    start();
    QMenu* menu = window_->actions().sessions;
    emit menu->aboutToShow();
    menu->actions().front()->trigger();
    QTRY_COMPARE(window_->runs().count(), 1);
    QCOMPARE(window_->runs().record(0).note, QStringLiteral("the best"));
}

void TestSession::bringsBackWhatWasClosedWithoutSaving()
{
    start();
    run();
    window_->close();
    QVERIFY(question(*window_, "closing")->informativeText().contains(QStringLiteral("stays on this computer")));
    answer(*window_, "closing", QStringLiteral("Close without saving"));
    QVERIFY(!window_->isVisible());
    start();
    QVERIFY(offered().isEmpty()); // the user decided
    QMenu* menu = window_->actions().sessions;
    emit menu->aboutToShow();
    QCOMPARE(menu->actions().size(), 1);
    QVERIFY2(menu->actions().front()->text().endsWith(QStringLiteral(": 1 run")),
             qPrintable(menu->actions().front()->text()));
    run();
    menu->actions().front()->trigger();
    QTRY_COMPARE(window_->runs().count(), 2);
    QTRY_VERIFY(!session().restoring());
    QCOMPARE(window_->runs().record(1).number, 2);
    QCOMPARE(SessionFolder::all().size(), 1);
}

void TestSession::startsWithTheDefaultCaseIfWanted()
{
    start(true, QStringLiteral("fig12a"));
    window_->close();
    MainWindow again;
    again.openLastCase();
    QCOMPARE(again.files().sample(), QStringLiteral("fig12a"));
    again.actions().reopen->trigger();
    MainWindow fresh;
    QVERIFY(!fresh.actions().reopen->isChecked());
    fresh.openLastCase();
    QCOMPARE(fresh.files().sample(), QStringLiteral("fig10a"));
}

void TestSession::removesTheOldestClosedSessions()
{
    for (const char* noNumber : {"many", "-5", ""}) {
        QSettings().setValue("session/budget", noNumber);
        QCOMPARE(Session::budget(), Session::defaultBudget);
    }
    // From the oldest: one that broke off, three that were closed, one that broke off; each has 1000 bytes of a run.
    QStringList paths;
    for (const bool closed : {false, true, true, true, false}) {
        QString problem;
        const std::unique_ptr<SessionFolder> folder = SessionFolder::create(problem);
        QCOMPARE(problem, QString());
        SessionState state;
        state.closed = closed;
        for (const auto& [file, bytes] :
             {std::pair(folder->stateFile(), toJson(state)), std::pair(folder->runFile(1), QByteArray(1000, 'x'))}) {
            QFile written(file);
            QVERIFY(written.open(QIODevice::WriteOnly));
            QCOMPARE(written.write(bytes), bytes.size());
        }
        paths << folder->path();
    }
    QCOMPARE(SessionFolder::ended(), QStringList(paths.rbegin(), paths.rend()));
    const auto bytesOf = [&paths](std::initializer_list<int> which) {
        qint64 bytes = 0;
        for (const int i : which) bytes += bytesIn(paths[i]);
        return bytes;
    };
    const qint64 all = bytesOf({0, 1, 2, 3, 4});
    QCOMPARE(keepSessionsWithin(all), all);
    QCOMPARE(SessionFolder::all().size(), 5);
    const qint64 without1 = bytesOf({0, 2, 3, 4}), without123 = bytesOf({0, 4});
    QCOMPARE(keepSessionsWithin(all - 1), without1);
    QVERIFY(!QFileInfo::exists(paths[1]));
    QCOMPARE(keepSessionsWithin(without123), without123);
    QVERIFY(!QFileInfo::exists(paths[2]) && !QFileInfo::exists(paths[3]));
    keepSessionsWithin(0);
    QVERIFY(!QFileInfo::exists(paths[0]));
    QVERIFY(QFileInfo::exists(paths[4])); // the newest that broke off is what the next start offers
}

void TestSession::goesOnInMemoryWhenTheDiskIsFull()
{
    start();
    QTRY_VERIFY(QFileInfo::exists(onlyFolder() + QStringLiteral("/session.json")));
    const test::FileSizeLimit limit(16 << 10);
    run();
    QTRY_VERIFY(question(*window_, "notKept"));
    QVERIFY2(question(*window_, "notKept")->text().contains(QStringLiteral("run1.h5")),
             qPrintable(question(*window_, "notKept")->text()));
    answer(*window_, "notKept", QStringLiteral("OK"));
    QCOMPARE(window_->runs().record(0).summary->status, RunStatus::Completed);
    QCOMPARE(window_->runs().record(0).sampleCount(), std::size_t(20'001));
    QVERIFY(window_->runs().record(0).kept.isEmpty());
    QSignalSpy told(window_->findChild<Session*>(), &Session::failed);
    run();
    window_->findChild<Session*>()->wait();
    QCoreApplication::processEvents(); // takes the messages of the writer
    QCOMPARE(told.count(), 0);         // said once
    QCOMPARE(window_->runs().record(1).sampleCount(), std::size_t(20'001));
    window_->close();
    const QString closing = question(*window_, "closing")->informativeText();
    QVERIFY2(!closing.contains(QStringLiteral("stays on this computer")), qPrintable(closing));
}

void TestSession::saysAllTheTimeThatNothingIsKept()
{
    const QString place = data_->filePath(QStringLiteral("touchdown"));
    QFile inTheWay(place);
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    inTheWay.close();
    start();
    const QLabel& mark = *window_->findChild<QLabel*>(QStringLiteral("notKept"));
    QVERIFY(mark.isVisible());
    QVERIFY2(mark.toolTip().contains(place), qPrintable(mark.toolTip()));
    run(); // its message takes the place of the first one
    run();
    window_->runs().remove(1);
    window_->film().solutions().add(test::sampleFilmCase(), test::sampleSteady());
    window_->film().solutions().remove(0);
    QVERIFY(mark.isVisible());
    QMenu* menu = window_->actions().sessions;
    emit menu->aboutToShow();
    QVERIFY2(menu->actions().front()->text().contains(place), qPrintable(menu->actions().front()->text()));
    // What kept it from being written is gone.
    QVERIFY(QFile::remove(place));
    session().keepAgain();
    QTRY_VERIFY(!mark.isVisible());
    QCOMPARE(readResults((onlyFolder() + "/run1.h5").toStdString()).samples.size(),
             window_->runs().record(0).sampleCount());
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("1 run.")), qPrintable(offered()));
}

void TestSession::keepsAllAgainWhenItsFolderWasRemoved()
{
    start();
    run();
    edit("springs.flying_height", QStringLiteral("4"));
    QTRY_VERIFY(!window_->runs().record(0).kept.isEmpty());
    QVERIFY(QDir(onlyFolder()).removeRecursively());
    // The window looks at its folder every two seconds.
    QTRY_VERIFY(question(*window_, "notKept"));
    answer(*window_, "notKept", QStringLiteral("OK"));
    const QLabel& mark = *window_->findChild<QLabel*>(QStringLiteral("notKept"));
    QTRY_VERIFY(!mark.isVisible());
    kill();
    start();
    QVERIFY2(offered().contains(QStringLiteral("the case fig10a with its edits, 1 run.")), qPrintable(offered()));
}

TOUCHDOWN_TEST(TestSession)

} // namespace test_session

#include "test_session.moc"
