// SPDX-License-Identifier: GPL-3.0-or-later
//
// How sessions end and what the next start offers: closing, killing, a full disk. A window that is destroyed without
// being closed leaves its folder as a kill does.
#include "ui/sessions/session.h"

#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "core/results/results_reader.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"
#include "tests/ui/sessions/window_session.h"
#include "ui/case/case_edits.h"
#include "ui/film/film_window.h"
#include "ui/runs/run_record.h"
#include "ui/sessions/session_offer.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_session_closing {

class TestSessionClosing : public QObject, test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase() { useNames("test_closing"); } // a longer path is broken in a tool tip
    void init() { begin(); }
    void cleanup() { end(); }
    void asksAgainLater();
    void discards();
    void offersNothingWithoutWork();
    void leavesALiveSessionAlone();
    void asksNothingWhenACaseWasNamed();
    void endsWithoutATraceWhenAllIsSaved();
    void keepsTheNoteOfASavedRun();
    void bringsBackWhatWasClosedWithoutSaving();
    void keepsTheChangesOfASample();
    void asksForTheChangesOfAFile();
    void startsWithTheDefaultCaseIfWanted();
    void removesTheOldestClosedSessions();
    void goesOnInMemoryWhenTheDiskIsFull();
    void saysAllTheTimeThatNothingIsKept();
    void keepsAllAgainWhenItsFolderWasRemoved();
};

void TestSessionClosing::asksAgainLater()
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

void TestSessionClosing::discards()
{
    start();
    run();
    kill();
    start();
    answer(*window_, "restoreSession", QStringLiteral("Discard"));
    QCOMPARE(window_->runs().count(), 0);
    QCOMPARE(SessionFolder::all().size(), 1); // that of this window
}

void TestSessionClosing::offersNothingWithoutWork()
{
    start();
    kill();
    start();
    QVERIFY(offered().isEmpty());
    QCOMPARE(SessionFolder::all().size(), 1);
}

void TestSessionClosing::leavesALiveSessionAlone()
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

void TestSessionClosing::asksNothingWhenACaseWasNamed()
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

void TestSessionClosing::endsWithoutATraceWhenAllIsSaved()
{
    start();
    run();
    window_->runs().setFile(1, QStringLiteral("mine.h5"));
    window_->close();
    QVERIFY(!window_->isVisible());
    QVERIFY(SessionFolder::all().isEmpty());
}

/// A results file has no place for it.
void TestSessionClosing::keepsTheNoteOfASavedRun()
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

void TestSessionClosing::bringsBackWhatWasClosedWithoutSaving()
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

void TestSessionClosing::keepsTheChangesOfASample()
{
    start();
    window_->edits().enter(*findParameter("springs.flying_height"), QStringLiteral("4"));
    window_->close();
    QVERIFY(!window_->isVisible()); // without a question
    start();
    QMenu* menu = window_->actions().sessions;
    emit menu->aboutToShow();
    menu->actions().front()->trigger();
    QTRY_COMPARE(window_->edits().value().springs.flyingHeight, 4e-9);
}

void TestSessionClosing::asksForTheChangesOfAFile()
{
    start();
    const QString file = data_->filePath(QStringLiteral("mine.toml"));
    QCOMPARE(window_->files().write(file), QString());
    window_->edits().enter(*findParameter("springs.flying_height"), QStringLiteral("4"));
    window_->close();
    QVERIFY(window_->isVisible());
    answer(*window_, "closing", QStringLiteral("Close without saving"));
}

void TestSessionClosing::startsWithTheDefaultCaseIfWanted()
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

void TestSessionClosing::removesTheOldestClosedSessions()
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

void TestSessionClosing::goesOnInMemoryWhenTheDiskIsFull()
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

void TestSessionClosing::saysAllTheTimeThatNothingIsKept()
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

void TestSessionClosing::keepsAllAgainWhenItsFolderWasRemoved()
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

TOUCHDOWN_TEST(TestSessionClosing)

} // namespace test_session_closing

#include "test_session_closing.moc"
