// SPDX-License-Identifier: GPL-3.0-or-later
//
// A caller may close standard input, output or error: no file that the program opens gets their numbers.
#include <QtTest>
#include <csignal>
#include <memory>

#include <unistd.h>

#include "core/results/results_reader.h"
#include "tests/support/command_process.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_standard_streams {

QString openAs(const QProcess& process, int descriptor)
{
    return QFile::symLinkTarget(QStringLiteral("/proc/%1/fd/%2").arg(process.processId()).arg(descriptor));
}

class TestStandardStreams : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }

    void ofTheCommandLine_data() { descriptors(); }
    /// The results file is open at all times, and progress is written once a second.
    void ofTheCommandLine()
    {
        QFETCH(const int, closed);
        QProcess process;
        process.setWorkingDirectory(folder_->path());
        process.setChildProcessModifier([closed] { ::close(closed); });
        process.start(TOUCHDOWN_COMMAND, {"run", "fig10a", "--set", "run.duration=9 s", "--out", "a.h5", "--progress"});
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(folder_->path("a.h5")), 20000);
        QCOMPARE(openAs(process, closed), QStringLiteral("/dev/null"));
        const std::string file = folder_->path("a.h5").toStdString();
        QTRY_VERIFY_WITH_TIMEOUT(readResults(file).samples.size() > 0, 20000);
        process.terminate();
        QCOMPARE(outcome(process).code, 1);
        const StoredRun run = readResults(file);
        QCOMPARE(run.problem, std::string());
        QCOMPARE(run.status, std::string("cancelled"));
    }

    /// A result that nobody can have is a failure, not a success.
    void aClosedOutputIsReported()
    {
        QProcess process;
        process.setChildProcessModifier([] { ::close(STDOUT_FILENO); });
        process.start(TOUCHDOWN_COMMAND, {"list"});
        const Outcome o = outcome(process);
        QCOMPARE(o.code, 1);
        QVERIFY2(o.err.contains("cannot write to standard output"), o.err);
    }

#ifdef TOUCHDOWN_WORKBENCH
    void ofTheWorkbench_data() { descriptors(); }
    void ofTheWorkbench()
    {
        QFETCH(const int, closed);
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("QT_QPA_PLATFORM", "offscreen");
        process.setProcessEnvironment(environment);
        process.setChildProcessModifier([closed] { ::close(closed); });
        process.start(TOUCHDOWN_WORKBENCH, {"fig10a"});
        QTRY_COMPARE_WITH_TIMEOUT(openAs(process, closed), QStringLiteral("/dev/null"), 20000);
        process.kill();
        QVERIFY(process.waitForFinished(20000));
    }
#endif

private:
    void descriptors()
    {
        QTest::addColumn<int>("closed");
        QTest::newRow("standard input") << 0;
        QTest::newRow("standard output") << 1;
        QTest::newRow("standard error") << 2;
    }
    std::unique_ptr<CommandFolder> folder_;
};

TOUCHDOWN_TEST(TestStandardStreams)

} // namespace test_standard_streams

#include "test_standard_streams.moc"
