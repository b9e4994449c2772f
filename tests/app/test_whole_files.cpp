// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every file that the program writes appears whole or not at all, and the program says why.
#include <QtTest>
#include <csignal>
#include <memory>

#include <sys/resource.h>
#include <sys/stat.h>

#include "core/results/results_reader.h"
#include "tests/support/command_process.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_whole_files {

class TestWholeFiles : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }

    void fullDisk_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("most"); // size of a file [byte]
        const auto row = [](const char* name, const QStringList& arguments, int most) {
            QTest::newRow(name) << arguments << most;
        };
        row("time series", {"run", "fig10a", "--csv", "a.csv"}, 100'000);
        row("table of a study", {"study", "hysteresis", "fig10a", "--csv", "a.csv"}, 100);
        row("report of a study", {"study", "hysteresis", "fig10a", "--out", "a.h5"}, 5'000);
        row("static state", {"steady", "film_plane", "--out", "a.h5"}, 5'000);
        row("case file", {"convert", "film_pico", "a.toml"}, 1'000);
        row("archive of CML", {"convert", "film_pico", "a.cml"}, 500);
        row("folder of CML", {"convert", "film_pico", "a"}, 500);
    }
    void fullDisk()
    {
        QFETCH(QStringList, arguments);
        QFETCH(int, most);
        QProcess process;
        process.setWorkingDirectory(folder_->path());
        process.setChildProcessModifier([most] {
            const rlimit limit{static_cast<rlim_t>(most), static_cast<rlim_t>(most)};
            ::setrlimit(RLIMIT_FSIZE, &limit);
            std::signal(SIGXFSZ, SIG_DFL);
        });
        process.start(TOUCHDOWN_COMMAND, arguments);
        const Outcome o = outcome(process);
        QVERIFY2(o.code == 1 || o.code == 2, o.err);
        QVERIFY2(o.err.contains("File too large") || o.err.contains("cannot write"), o.err);
        QVERIFY2(o.err.contains(arguments.last().toUtf8()), o.err);
        QCOMPARE(folder_->files(), QStringList());
    }

    /// As "head" does. The results are on the disk all the same.
    void aReaderThatLeaves()
    {
        const QString pipe = folder_->path() + QStringLiteral("/pipe"),
                      file = folder_->path() + QStringLiteral("/a.h5");
        QCOMPARE(::mkfifo(qPrintable(pipe), 0600), 0);
        QProcess process;
        process.setWorkingDirectory(folder_->path());
        process.setChildProcessModifier([] { std::signal(SIGPIPE, SIG_DFL); });
        process.start(TOUCHDOWN_COMMAND, {"run", "fig10a", "--csv", "pipe", "--out", "a.h5"});
        {
            QFile reader(pipe);
            QVERIFY(reader.open(QIODevice::ReadOnly | QIODevice::Unbuffered));
            QVERIFY(reader.read(100).startsWith("time"));
        }
        const Outcome o = outcome(process);
        QVERIFY2(o.code == 1 || o.code == 2, o.err);
        QVERIFY2(o.err.contains("pipe: Broken pipe"), o.err);
        const StoredRun run = readResults(file.toStdString());
        QVERIFY(run.problem.empty() && run.samples.size() > 0);
        QVERIFY(run.status != "interrupted");
        QCOMPARE(folder_->files(), QStringList(QStringLiteral("a.h5")));
    }

private:
    std::unique_ptr<CommandFolder> folder_;
};

TOUCHDOWN_TEST(TestWholeFiles)

} // namespace test_whole_files

#include "test_whole_files.moc"
