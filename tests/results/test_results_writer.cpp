// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_writer.h"

#include <cstdio>
#include <random>
#include <string_view>

#include <sys/stat.h>

#include <QtTest>

#include "tests/support/sample_results.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace std::chrono_literals;

namespace test_results_writer {

namespace fs = std::filesystem;

constexpr std::size_t batchSize = 700;
constexpr std::size_t batchesPerSnapshot = 10;

const std::vector<RecordedFields> twoSets{
    {"fields", {{0.0, 1.0, 2.0}, {0.0, 1.0}}, {{"gap", "m", "nm", "Gap"}}},
    {"contact_fields", {{0.0, 1.0}, {0.0, 1.0}}, {{"contact_pressure", "Pa", "MPa", "Pressure"}}}};

/// One snapshot of each set with every tenth batch.
std::vector<FieldSnapshot> sampleSnapshots(std::size_t batch)
{
    if (batch % batchesPerSnapshot != 0) return {};
    const auto k = static_cast<double>(batch);
    return {{k, 0, {{k, -k}}}, {k, 1, {{1e6 * k}}}};
}

ino_t inodeOf(const char* file)
{
    struct stat status {};
    return ::stat(file, &status) == 0 ? status.st_ino : 0;
}

// The program that is killed: writes without end, and tells of each batch.
int writeUntilKilled(const char* file)
{
    ResultsWriter writer(1ms);
    std::string problem = writer.open(file, sampleCase(), sampleCaseText, sampleQuantities, twoSets);
    const ino_t first = inodeOf(file);
    bool flushed = false;
    for (std::size_t k = 0; problem.empty(); ++k) {
        problem = writer.append(sampleBatch(k * batchSize, batchSize), sampleSnapshots(k));
        if (!flushed && inodeOf(file) == first) continue; // the file without samples
        flushed = true;
        std::putchar('.');
        std::fflush(stdout);
    }
    std::fprintf(stderr, "%s\n", problem.c_str());
    return 1;
}

// A program of its own as well: a process that has started programs and then starts threads, as the writer does,
// cannot be followed by the thread sanitizer.
int writeToTheEnd(const char* file)
{
    ResultsWriter writer;
    if (!writer.open(file, sampleCase(), sampleCaseText, sampleQuantities).empty()) return 1;
    return writer.finish(sampleSummary()).empty() ? 0 : 1;
}

class TestResultsWriter : public QObject {
    Q_OBJECT

private slots:
    void init();
    void killedWritersLeaveWholeFiles();

private:
    fs::path path(const char* name = "run.h5") const { return fs::path(folder_->path().toStdString()) / name; }
    std::unique_ptr<QTemporaryDir> folder_;
};

void TestResultsWriter::init()
{
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(folder_->isValid());
}

// The writer flushes without pause, so that nearly every kill falls into a flush; when it dies is decided
// by how much it has told of, and by what the machine does meanwhile.
void TestResultsWriter::killedWritersLeaveWholeFiles()
{
    std::mt19937 random(7);
    std::uniform_int_distribution<qint64> patience(1, 120);
    for (int round = 0; round < 60; ++round) {
        QProcess writer;
        writer.start(QCoreApplication::applicationFilePath(), {"write_until_killed", path().c_str()});
        const qint64 wanted = patience(random);
        while (writer.bytesAvailable() < wanted && writer.state() != QProcess::NotRunning)
            writer.waitForReadyRead(5000);
        QVERIFY2(writer.state() == QProcess::Running, writer.readAllStandardError().constData());
        writer.kill();
        QVERIFY(writer.waitForFinished());

        const StoredRun run = readResults(path());
        QVERIFY2(run.problem.empty(), run.problem.c_str());
        QCOMPARE(run.status, std::string("interrupted"));
        QCOMPARE(run.caseText, sampleCaseText);
        QVERIFY(run.samples.size() > 0);
        QCOMPARE(wrongSample(run.samples), QString());
        QCOMPARE(run.recorded.size(), twoSets.size());
        const std::size_t batches = run.samples.size() / batchSize;
        QCOMPARE(run.fields.size(), 2 * ((batches + batchesPerSnapshot - 1) / batchesPerSnapshot));
        for (std::size_t i = 0; i < run.fields.size(); ++i) {
            QCOMPARE(run.fields[i].set, i % 2);
            QCOMPARE(run.fields[i].values, sampleSnapshots(i / 2 * batchesPerSnapshot)[i % 2].values);
        }
        fs::remove(path());
    }
    // What the killed left beside the file hinders nobody.
    QProcess writer;
    writer.start(QCoreApplication::applicationFilePath(), {"write_to_the_end", path().c_str()});
    QVERIFY(writer.waitForFinished());
    QCOMPARE(writer.exitCode(), 0);
    QCOMPARE(readResults(path()).status, std::string("failed"));
    QCOMPARE(QDir(folder_->path()).entryList(QDir::Files), QStringList{"run.h5"});
}

static const touchdown::test::Program untilKilled("write_until_killed",
                                                  [](int, char** argv) { return writeUntilKilled(argv[1]); });
static const touchdown::test::Program toTheEnd("write_to_the_end",
                                               [](int, char** argv) { return writeToTheEnd(argv[1]); });
TOUCHDOWN_TEST(TestResultsWriter)

} // namespace test_results_writer

#include "test_results_writer.moc"
