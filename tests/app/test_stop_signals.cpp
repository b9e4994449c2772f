// SPDX-License-Identifier: GPL-3.0-or-later
//
// A signal while the input is still read.
#include <QtTest>
#include <csignal>
#include <memory>

#include "tests/support/command_process.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_stop_signals {

/// Processor time of a process so far [clock ticks]; -1 after its end.
long processorTime(qint64 process)
{
    QFile file(QStringLiteral("/proc/%1/stat").arg(process));
    if (!file.open(QIODevice::ReadOnly)) return -1;
    const QByteArray text = file.readAll();
    const QList<QByteArray> fields = text.mid(text.lastIndexOf(')') + 2).split(' '); // from the third field on
    return fields.size() > 12 ? fields[11].toLong() + fields[12].toLong() : -1;
}

class TestStopSignals : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }

    /// The study has so many statements that its reading takes about a second: the signal comes long before its end,
    /// and long after the beginning of the program.
    void whileTheInputIsRead_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("SIGINT") << SIGINT;
        QTest::newRow("SIGTERM") << SIGTERM;
        QTest::newRow("SIGHUP") << SIGHUP;
    }
    void whileTheInputIsRead()
    {
        QFETCH(const int, signal);
        QByteArray study("kind = \"statements\"\ncase = \"fig10a\"\n");
        for (int i = 0; i < 1500; ++i) study += "[[statement]]\nfigure = \"1\"\nquote = \"q\"\nend = [\"flying\"]\n";
        folder_->put("many.toml", study);
        QProcess process;
        process.setWorkingDirectory(folder_->path());
        process.start(TOUCHDOWN_COMMAND, {"study", "statements", "many.toml", "--json"});
        QVERIFY(process.waitForStarted());
        const long ticks = 10; // 0.1 s; the program itself begins within a hundredth of that
        QVERIFY(QTest::qWaitFor([&] { return processorTime(process.processId()) >= ticks; }, 20000));
        QCOMPARE(::kill(static_cast<pid_t>(process.processId()), signal), 0);
        const Outcome o = outcome(process);
        QCOMPARE(o.code, 1);
        QCOMPARE(o.json()["status"].toString(), "cancelled");
        QVERIFY2(o.errorLines().last().startsWith("cancelled"), o.err);
    }

    /// From a closed terminal it may come twice; under nohup it is ignored, and the run goes on.
    void repeatedAndIgnoredHangUp()
    {
        for (const bool ignored : {false, true}) {
            QProcess process;
            process.setWorkingDirectory(folder_->path());
            process.setChildProcessModifier([ignored] { std::signal(SIGHUP, ignored ? SIG_IGN : SIG_DFL); });
            process.start(TOUCHDOWN_COMMAND,
                          {"run", "fig10a", "--set", "run.duration=9 s", "--out", "a.h5", "--progress", "--json"});
            process.setReadChannel(QProcess::StandardError);
            QVERIFY(process.waitForReadyRead(20000));
            const auto id = static_cast<pid_t>(process.processId());
            for (int i = 0; i < 3; ++i) QCOMPARE(::kill(id, SIGHUP), 0);
            if (ignored) {
                process.readAllStandardError();
                QVERIFY(process.waitForReadyRead(20000)); // the next line
                QCOMPARE(::kill(id, SIGTERM), 0);
            }
            QCOMPARE(outcome(process).json()["status"].toString(), "cancelled");
        }
    }

    /// Commands without a calculation end at once, as any program does.
    void othersEndAtOnce()
    {
        QProcess process;
        process.setWorkingDirectory(folder_->path());
        QByteArray study("kind = \"statements\"\ncase = \"fig10a\"\n");
        for (int i = 0; i < 1500; ++i) study += "[[statement]]\nfigure = \"1\"\nquote = \"q\"\nend = [\"flying\"]\n";
        folder_->put("many.toml", study);
        process.start(TOUCHDOWN_COMMAND, {"validate", "many.toml"});
        QVERIFY(process.waitForStarted());
        QVERIFY(QTest::qWaitFor([&] { return processorTime(process.processId()) >= 10; }, 20000));
        QCOMPARE(::kill(static_cast<pid_t>(process.processId()), SIGINT), 0);
        QVERIFY(process.waitForFinished(20000));
        QCOMPARE(process.exitStatus(), QProcess::CrashExit);
    }

private:
    std::unique_ptr<CommandFolder> folder_;
};

TOUCHDOWN_TEST(TestStopSignals)

} // namespace test_stop_signals

#include "test_stop_signals.moc"
