// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program is killed at random moments of a run; a window of the test then is the next start.
#include "ui/sessions/session.h"

#include <algorithm>
#include <random>

#include <csignal>

#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "core/results/results_reader.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/window/main_window.h"

using namespace touchdown;

namespace test_session_recovery {

class TestSessionRecovery : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void offersTheRunAfterAKill_data();
    void offersTheRunAfterAKill();
    void keepsOutOfTheFolderOfTheProgram();

private:
    /// The program with a run of a case that lasts much longer than the test.
    void startProgram(QProcess& program)
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
        program.setProcessEnvironment(environment);
        program.start(QStringLiteral(TOUCHDOWN_WORKBENCH), {case_, QStringLiteral("--run")});
        QVERIFY(program.waitForStarted());
    }
    static QStringList runFiles()
    {
        QStringList files;
        for (const QString& folder : SessionFolder::all()) {
            const QString file = folder + QStringLiteral("/run1.h5");
            if (QFileInfo::exists(file)) files << file;
        }
        return files;
    }

    QTemporaryDir home_;
    QString case_;
};

void TestSessionRecovery::initTestCase()
{
    // The same surroundings as those of the program.
    qputenv("XDG_DATA_HOME", home_.filePath(QStringLiteral("data")).toLocal8Bit());
    qputenv("XDG_CONFIG_HOME", home_.filePath(QStringLiteral("config")).toLocal8Bit());
    QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
    QCoreApplication::setApplicationName(QStringLiteral("touchdown-workbench"));
    case_ = home_.filePath(QStringLiteral("long.toml"));
    QFile file(case_);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("[run]\nduration = \"100 s\"\nsample_interval = \"1 us\"\n");
    QSettings settings;
    settings.setValue(QStringLiteral("runs/pace"), 1); // 1 ms/s
}

void TestSessionRecovery::offersTheRunAfterAKill_data()
{
    QTest::addColumn<int>("moment"); // after the first samples are on disk [ms]
    std::mt19937 random(20261126);
    const int kills = std::max(4, qEnvironmentVariableIntValue("TOUCHDOWN_KILLS"));
    for (int i = 1; i <= kills; ++i) QTest::addRow("kill %d", i) << std::uniform_int_distribution<int>(0, 900)(random);
}

void TestSessionRecovery::offersTheRunAfterAKill()
{
    QFETCH(const int, moment);
    QProcess program;
    startProgram(program);
    QTRY_COMPARE_WITH_TIMEOUT(runFiles().size(), qsizetype(1), 30'000);
    QTRY_VERIFY_WITH_TIMEOUT(readResults(runFiles().front().toStdString()).samples.size() > 0, 30'000);
    program.waitForFinished(moment); // the moment of the kill is what the row is about
    ::kill(static_cast<pid_t>(program.processId()), SIGKILL);
    program.waitForFinished();
    QCOMPARE(program.exitStatus(), QProcess::CrashExit);
    const StoredRun stored = readResults(runFiles().front().toStdString());
    QCOMPARE(stored.problem, std::string());

    MainWindow window;
    window.openLastCase();
    window.show();
    window.beginSession(true);
    const QMessageBox* box = question(window, "restoreSession");
    QVERIFY(box);
    QVERIFY2(box->informativeText().contains(QStringLiteral("1 run, which was interrupted")),
             qPrintable(box->informativeText()));
    answer(window, "restoreSession", QStringLiteral("Restore"));
    QTRY_COMPARE(window.runs().count(), 1);
    QTRY_VERIFY(!window.findChild<Session*>()->restoring());
    QVERIFY(window.runs().record(0).interrupted);
    QCOMPARE(window.runs().record(0).sampleCount(), stored.samples.size());
    QVERIFY(stored.samples.size() > 0);
    QCOMPARE(window.files().file(), case_);
    window.runs().remove(0);
    window.close();
    QVERIFY(!window.isVisible());
    QVERIFY(SessionFolder::all().isEmpty());
}

void TestSessionRecovery::keepsOutOfTheFolderOfTheProgram()
{
    QProcess program;
    startProgram(program);
    QTRY_COMPARE_WITH_TIMEOUT(runFiles().size(), qsizetype(1), 30'000);
    {
        MainWindow window;
        window.openLastCase();
        window.show();
        window.beginSession(true);
        QVERIFY(!question(window, "restoreSession"));
        QCOMPARE(SessionFolder::all().size(), 2);
        window.close();
    }
    QCOMPARE(runFiles().size(), qsizetype(1));
    program.kill();
    program.waitForFinished();
}

TOUCHDOWN_TEST(TestSessionRecovery)

} // namespace test_session_recovery

#include "test_session_recovery.moc"
