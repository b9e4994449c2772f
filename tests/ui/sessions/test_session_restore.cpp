// SPDX-License-Identifier: GPL-3.0-or-later
//
// A window takes over what a killed one left: nothing is lost, doubled or replaced.
#include "ui/sessions/session.h"

#include <utility>

#include <QDir>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/case_files/case_text.h"
#include "core/results/steady_writer.h"
#include "core/studies/study/study_file_reader.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"
#include "tests/ui/sample_study.h"
#include "tests/ui/sessions/window_session.h"
#include "ui/film/film_window.h"
#include "ui/film/solution_files.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_window.h"
#include "ui/style/message_strip.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_session_restore {

class TestSessionRestore : public QObject, test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase() { useNames("test_session_restore"); }
    void init() { begin(); }
    void cleanup() { end(); }
    void keepsThePage();
    void savesARestoredRunWhole();
    void leavesARunThatCannotBeRead();
    void leavesARunThatCannotBeMoved();
    void leavesASolutionThatCannotBeRead();
    void leavesAReportWhoseKindIsTaken();
    void opensASeriesOnce();
    void withdrawsAQuestionAboutOutsideFiles();
    void asksBeforeItReadsASurfaceThatLiesOutsideByNow();
    void losesNothingWhenItIsStopped();
    void losesNothingWhenItIsKilled();
    void leavesAnEditedTextWhereTheWindowHasOne();
    void keepsAnewRunOutOfTheNumbersOfOthers();
    void tellsManyRefusalsInOneLine();
    void opensNoFileThatHoldsAnotherRunByNow();
    void leavesAllWhereItsOwnStateCannotBeWritten();

private:
    /// Runs with the notes "note 1", "note 2", ... and edits of the case; then the window is killed.
    void leaveRuns(int count)
    {
        start();
        window_->edits().enter(*findParameter("run.duration"), QStringLiteral("10 µs"));
        for (int i = 0; i < count; ++i) {
            run();
            window_->runs().setData(window_->runs().index(i), QStringLiteral("note %1").arg(i + 1),
                                    RecordList::NoteRole);
        }
        start();
    }
    QStringList notes() const
    {
        QStringList all;
        for (int row = 0; row < window_->runs().count(); ++row) all << window_->runs().record(row).note;
        return all;
    }
    void addStudy(const StudyReport& report)
    {
        window_->studies().restore({report, "", "", ""});
        emit window_->studies().ended(report);
    }
    QString message() const { return window_->findChild<MessageStrip*>()->text(); }
    static QByteArray content(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    static void write(const QString& path, const QByteArray& bytes)
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
};

void TestSessionRestore::keepsThePage()
{
    start();
    window_->setPage(MainWindow::Page::Studies);
    QTRY_COMPARE(readSession(onlyFolder()).page, static_cast<int>(MainWindow::Page::Studies));
}

/// The window has read only a part of its file: not the events, the figures and the verdict.
void TestSessionRestore::savesARestoredRunWhole()
{
    start();
    run();
    start();
    restore();
    const RunRecord& restored = window_->runs().record(0);
    const QByteArray kept = content(restored.kept);
    QVERIFY(!kept.isEmpty());
    const QString file = data_->filePath(QStringLiteral("saved.h5"));
    QCOMPARE(saveHdf5(restored, file), QString());
    QVERIFY(content(file) == kept);
}

void TestSessionRestore::leavesARunThatCannotBeRead()
{
    start();
    run();
    run();
    const QString folder = onlyFolder(), bad = folder + QStringLiteral("/run1.h5");
    window_.reset();
    write(bad, "no results");
    start();
    restore();
    QCOMPARE(window_->runs().count(), 1);
    QCOMPARE(window_->runs().record(0).number, 2);
    QVERIFY2(message().contains(bad), qPrintable(message()));
    QCOMPARE(content(bad), QByteArray("no results"));
    const SessionState left = readSession(folder);
    QCOMPARE(left.runs.size(), std::size_t(1));
    QCOMPARE(left.runs.front().number, 1);
    QVERIFY(!left.edited.modified);
}

void TestSessionRestore::leavesARunThatCannotBeMoved()
{
    start();
    run();
    const QString there = onlyFolder() + QStringLiteral("/run1.h5");
    start();
    const QString taken = session().folder()->runFile(1);
    write(taken, "in the way");
    restore();
    QCOMPARE(window_->runs().count(), 0);
    QVERIFY2(message().contains(there), qPrintable(message()));
    QVERIFY(QFileInfo::exists(there));
    QCOMPARE(content(taken), QByteArray("in the way"));
}

void TestSessionRestore::leavesASolutionThatCannotBeRead()
{
    start();
    window_->film().solutions().add(test::sampleFilmCase(), test::sampleSteady());
    window_->film().solutions().add(test::sampleFilmCase(), test::sampleSteady());
    const QString bad = onlyFolder() + QStringLiteral("/solution2.h5");
    window_.reset();
    write(bad, "no results");
    start();
    restore();
    QCOMPARE(window_->film().solutions().count(), 1);
    QVERIFY2(message().contains(bad), qPrintable(message()));
    QCOMPARE(content(bad), QByteArray("no results"));
}

void TestSessionRestore::leavesAReportWhoseKindIsTaken()
{
    start();
    StudyReport earlier = sampleReport();
    earlier.findings = {"Found earlier."};
    addStudy(earlier);
    const QString report = onlyFolder() + QStringLiteral("/study-work-precision.h5");
    start();
    addStudy(sampleReport());
    restore();
    QCOMPARE(window_->studies().outcome("work-precision")->report->findings, sampleReport().findings);
    QVERIFY2(message().contains(QStringLiteral("work-precision")), qPrintable(message()));
    QVERIFY(QFileInfo::exists(report));
    start();
    restore();
    QCOMPARE(window_->studies().outcome("work-precision")->report->findings, sampleReport().findings); // the newest
    start();
    answer(*window_, "restoreSession", QStringLiteral("Later"));
    QMenu* menu = window_->actions().sessions;
    emit menu->aboutToShow();
    QCOMPARE(menu->actions().size(), 2); // one for each report
}

void TestSessionRestore::opensASeriesOnce()
{
    Case c = test::sampleFilmCase();
    c.steady.radii = {20e-3, 25e-3, 30e-3};
    const QString file = data_->filePath(QStringLiteral("series.h5"));
    SteadyWriter writer;
    QCOMPARE(writer.open(file.toStdString(), c, formatCase(c)), std::string());
    for (const SteadySeriesPoint& point : seriesOf(c)) QCOMPARE(writer.add(point, test::sampleSteady()), std::string());
    QCOMPARE(writer.finish(SteadyStatus::Converged, ""), std::string());
    start();
    run(); // something that only the session has
    window_->files().open(file);
    SolutionsModel& solutions = window_->film().solutions();
    QCOMPARE(solutions.count(), 3);
    solutions.setData(solutions.index(2), QStringLiteral("outside"), RecordList::NoteRole);
    solutions.remove(1);
    start();
    restore();
    const SolutionsModel& restored = window_->film().solutions();
    QCOMPARE(restored.count(), 2);
    QCOMPARE(restored.record(0).value.disk.radius, 20e-3);
    QCOMPARE(restored.record(1).value.disk.radius, 30e-3);
    QCOMPARE(restored.record(1).note, QStringLiteral("outside"));
    QCOMPARE(restored.record(0).file, file);
    QCOMPARE(restored.record(1).file, file);
}

/// Its answer would replace what was restored.
void TestSessionRestore::withdrawsAQuestionAboutOutsideFiles()
{
    start();
    window_->edits().enter(*findParameter("springs.flying_height"), QStringLiteral("4"));
    const Case edited = window_->edits().value();
    window_.reset();
    QVERIFY(QDir(data_->path()).mkdir(QStringLiteral("case")));
    const QString file = data_->filePath(QStringLiteral("case/mine.toml"));
    QCOMPARE(writeCaseFile(file.toStdString(), "model = \"contact\"\n[disk.surface]\nkind = \"file\"\n"
                                               "motion = \"still\"\nfile = \"../track.txt\"\n"),
             std::string());
    start(true, file);
    QVERIFY(question(*window_, "outsideFiles"));
    restore();
    QVERIFY(!question(*window_, "outsideFiles"));
    QVERIFY(window_->edits().value() == edited);
}

/// As File > Open does. Without the answer the edits stay where they are.
void TestSessionRestore::asksBeforeItReadsASurfaceThatLiesOutsideByNow()
{
    QVERIFY(QDir(data_->path()).mkdir(QStringLiteral("case")));
    const QString file = data_->filePath(QStringLiteral("case/mine.toml"));
    const QString surface = data_->filePath(QStringLiteral("case/track.txt"));
    write(surface, "# x [um]  h [nm]\n0 0\n1 1\n2 0\n3 -1\n");
    write(file, "model = \"contact\"\n[disk.surface]\nkind = \"file\"\nmotion = \"still\"\nfile = \"track.txt\"\n");
    start(true, file);
    window_->edits().enter(*findParameter("approach.closest"), QStringLiteral("4"));
    const Case edited = window_->edits().value();
    window_.reset();
    const QString elsewhere = data_->filePath(QStringLiteral("private.txt"));
    QVERIFY(QFile::rename(surface, elsewhere) && QFile::link(elsewhere, surface));
    for (const char* chosen : {"No", "Yes"}) {
        start();
        restore();
        QVERIFY(question(*window_, "outsideFiles")->text().contains(QStringLiteral("track.txt")));
        QVERIFY(window_->edits().value() != edited);
        answer(*window_, "outsideFiles", QLatin1String(chosen));
        QTRY_VERIFY(!session().restoring() && !message().isEmpty());
        const bool allowed = chosen == std::string_view("Yes");
        QCOMPARE(window_->edits().value() == edited, allowed);
        QCOMPARE(message().contains(QStringLiteral("outside")), !allowed);
        QCOMPARE(SessionFolder::ended().size(), allowed ? 0 : 1);
    }
}

void TestSessionRestore::losesNothingWhenItIsStopped()
{
    leaveRuns(5);
    connect(&window_->runs(), &RecordList::added, &session().reader(), &SessionReader::stop);
    restore();
    QCOMPARE(notes(), QStringList{QStringLiteral("note 1")});
    QVERIFY2(message().contains(QStringLiteral("File, Sessions")), qPrintable(message()));
    QVERIFY(window_->files().modified());
    window_->runs().disconnect(&session().reader());
    QMenu* menu = window_->actions().sessions;
    emit menu->aboutToShow();
    QVERIFY2(menu->actions().front()->text().endsWith(QStringLiteral(": 4 runs")),
             qPrintable(menu->actions().front()->text()));
    window_->files().leaveUnsaved();
    menu->actions().front()->trigger();
    QTRY_COMPARE(window_->runs().count(), 5);
    QTRY_VERIFY(!session().restoring());
    QCOMPARE(notes().join(u' '), QStringLiteral("note 1 note 2 note 3 note 4 note 5"));
    QCOMPARE(SessionFolder::all().size(), 1);
}

/// The state of the window names all results before the first one is moved.
void TestSessionRestore::losesNothingWhenItIsKilled()
{
    leaveRuns(5);
    const auto lastOne = [this] { session().reader().blockSignals(true); };
    connect(&window_->runs(), &RecordList::added, this, lastOne);
    answer(*window_, "restoreSession", QStringLiteral("Restore"));
    QTRY_COMPARE(window_->runs().count(), 1);
    QCOMPARE(SessionFolder::all().size(), 2);
    start();
    QVERIFY2(question(*window_, "restoreSession")
                 ->informativeText()
                 .contains(QStringLiteral("the case fig10a with its edits, 5 runs.")),
             qPrintable(question(*window_, "restoreSession")->informativeText()));
    restore();
    QCOMPARE(notes().join(u' '), QStringLiteral("note 1 note 2 note 3 note 4 note 5"));
    QVERIFY(window_->files().modified());
    QCOMPARE(SessionFolder::all().size(), 1);
}

void TestSessionRestore::leavesAnEditedTextWhereTheWindowHasOne()
{
    start();
    window_->studies().editor()->setText(QStringLiteral("# of the earlier session\n"));
    start();
    window_->studies().editor()->setText(QStringLiteral("# of this one\n"));
    restore();
    QCOMPARE(window_->studies().editor()->toText(), QStringLiteral("# of this one\n"));
    QVERIFY2(message().contains(QStringLiteral("another edited text")), qPrintable(message()));
    QMenu* menu = window_->actions().sessions;
    emit menu->aboutToShow();
    QVERIFY2(menu->actions().front()->text().endsWith(QStringLiteral("the edited text of 1 study")),
             qPrintable(menu->actions().front()->text()));
}

void TestSessionRestore::keepsAnewRunOutOfTheNumbersOfOthers()
{
    leaveRuns(3);
    bool asked = false;
    connect(&window_->runs(), &RecordList::added, this, [&] {
        if (!std::exchange(asked, true)) window_->startRun();
    });
    restore();
    QTRY_VERIFY(!window_->controller().active());
    QCOMPARE(window_->runs().count(), 4);
    QVERIFY(window_->runs().find(4)->note.isEmpty());
    for (int number = 1; number <= 3; ++number)
        QCOMPARE(window_->runs().find(number)->note, QStringLiteral("note %1").arg(number));
}

void TestSessionRestore::tellsManyRefusalsInOneLine()
{
    leaveRuns(1);
    const QString folder = SessionFolder::ended().value(0);
    QVERIFY(folder.isEmpty()); // the offer holds it
    const QString held = SessionFolder::all().back();
    for (int number = 2; number <= 30; ++number) write(held + QStringLiteral("/run%1.h5").arg(number), "no results");
    restore();
    QCOMPARE(window_->runs().count(), 1);
    QVERIFY2(!message().contains(u'\n'), qPrintable(message()));
    const QMessageBox* box = question(*window_, "notRestored");
    QVERIFY(box);
    QCOMPARE(box->detailedText().count(u'\n'), 28);
    QVERIFY(QFileInfo::exists(held + QStringLiteral("/run30.h5")));
}

/// The session knows what the user's file was. Run 1 is only in that file, run 2 in the folder of the session, too.
void TestSessionRestore::opensNoFileThatHoldsAnotherRunByNow()
{
    leaveRuns(2);
    restore();
    const QString file = data_->filePath(QStringLiteral("mine.h5")),
                  other = data_->filePath(QStringLiteral("other.h5"));
    for (const QString& path : {file, other}) QCOMPARE(saveHdf5(window_->runs().record(1), path), QString());
    window_->runs().setFile(2, other);
    window_->files().open(file);
    QCOMPARE(window_->runs().count(), 3);
    window_->runs().setData(window_->runs().index(2), QStringLiteral("opened"), RecordList::NoteRole);
    for (const QString& path : {file, other})
        QCOMPARE(saveHdf5(window_->runs().record(0), path), QString()); // another run, under the same names
    start();
    restore();
    QCOMPARE(notes(), QStringList({QStringLiteral("note 1"), QStringLiteral("note 2")}));
    QVERIFY2(message().contains(file) && message().contains(QStringLiteral("opened")), qPrintable(message()));
    QVERIFY(window_->runs().record(1).file.isEmpty()); // it is not saved any more
}

/// Else a kill would lose the notes, which stand in no other file.
void TestSessionRestore::leavesAllWhereItsOwnStateCannotBeWritten()
{
    leaveRuns(1);
    const QString left = SessionFolder::all().back();
    const QByteArray state = content(left + QStringLiteral("/session.json"));
    QVERIFY(state.contains("note 1"));
    {
        const test::FileSizeLimit full(16); // [byte]
        restore();
        QVERIFY2(message().contains(QStringLiteral("stay in File, Sessions, Restore")), qPrintable(message()));
        QVERIFY(QFileInfo::exists(left + QStringLiteral("/run1.h5")));
        QVERIFY(content(left + QStringLiteral("/session.json")) == state);
    }
    QVERIFY(!readSession(left).closed); // a later start offers it again
}

TOUCHDOWN_TEST(TestSessionRestore)

} // namespace test_session_restore

#include "test_session_restore.moc"
