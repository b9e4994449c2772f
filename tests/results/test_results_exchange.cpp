// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_exchange.h"

#include <csignal>

#include <QtTest>
#include <sys/resource.h>

#include "core/formats/hdf5_file.h"
#include "tests/support/sample_results.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace std::chrono_literals;

namespace test_results_exchange {

namespace fs = std::filesystem;

class TestResultsExchange : public QObject {
    Q_OBJECT

private slots:
    void init();
    void oldFileStaysUntilTheNewOneIsWhole();
    void theFileIsThereFromTheFirstMoment();
    void readersDuringARunDisturbNothing();
    void symbolicLinkStaysALink();
    void secondWriterToOneName();
    void fileRemovedDuringARun();
    void fullDisk();

private:
    QStringList files() const { return QDir(folder_->path()).entryList(QDir::Files); }
    fs::path path(const char* name = "run.h5") const { return fs::path(folder_->path().toStdString()) / name; }
    std::unique_ptr<QTemporaryDir> folder_;
};

void TestResultsExchange::init()
{
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(folder_->isValid());
}

void TestResultsExchange::oldFileStaysUntilTheNewOneIsWhole()
{
    put(path(), "older results");
    {
        ResultsWriter unfinished(std::nullopt);
        QCOMPARE(unfinished.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
        QCOMPARE(unfinished.append(sampleBatch(0, 10)), std::string());
    }
    QCOMPARE(bytes(path()), std::string("older results"));
    QCOMPARE(files(), QStringList{"run.h5"});
    ResultsWriter writer(std::nullopt);
    QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
    // So many that some are written early.
    const std::size_t many = 1'000'000;
    for (std::size_t k = 0; k < many; k += many / 4) QCOMPARE(writer.append(sampleBatch(k, many / 4)), std::string());
    QCOMPARE(bytes(path()), std::string("older results"));
    QCOMPARE(writer.finish(sampleSummary()), std::string());
    QCOMPARE(readResults(path()).samples.size(), many);
    QCOMPARE(wrongSample(readResults(path()).samples), QString());
}

void TestResultsExchange::theFileIsThereFromTheFirstMoment()
{
    put(path(), "older results");
    fs::permissions(path(), fs::perms(0640));
    ResultsWriter writer(std::chrono::hours(1));
    QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
    const StoredRun run = readResults(path());
    QCOMPARE(run.problem, std::string());
    QCOMPARE(run.status, std::string("interrupted"));
    QCOMPARE(run.title, sampleCase().title);
    QCOMPARE(run.samples.size(), std::size_t{0});
    QCOMPARE(writer.append(sampleBatch(0, 10)), std::string());
    QCOMPARE(writer.finish(sampleSummary()), std::string());
    QCOMPARE(fs::status(path()).permissions(), fs::perms(0640));
}

void TestResultsExchange::readersDuringARunDisturbNothing()
{
    ResultsWriter writer(0ms);
    QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
    std::size_t k = 0;
    const auto append = [&] {
        const std::string problem = writer.append(sampleBatch(k, 500));
        k += 500;
        return problem;
    };
    QCOMPARE(append(), std::string());
    QTRY_VERIFY(fs::exists(path()));
    Hdf5Group reader;
    hsize_t seen = 0;
    {
        const Hdf5Access access;
        reader = openHdf5File(path());
        seen = reader.get("timeseries/time").length();
    }
    for (int i = 0; i < 40; ++i) {
        QCOMPARE(append(), std::string());
        QTRY_COMPARE(readResults(path()).samples.size(), k);
        const Hdf5Access access;
        QCOMPARE(reader.get("timeseries/time").length(), seen);
    }
    {
        const Hdf5Access access;
        reader.close();
    }
    QCOMPARE(writer.finish(sampleSummary()), std::string());
    QCOMPARE(wrongSample(readResults(path()).samples), QString());
}

void TestResultsExchange::symbolicLinkStaysALink()
{
    put(path("target.h5"), "older results");
    fs::create_symlink("target.h5", path());
    ResultsWriter writer;
    QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
    QCOMPARE(writer.finish(sampleSummary()), std::string());
    QVERIFY(fs::is_symlink(path()));
    QCOMPARE(readResults(path("target.h5")).problem, std::string());
}

void TestResultsExchange::secondWriterToOneName()
{
    ResultsWriter first(std::chrono::hours(1));
    ResultsWriter second(std::chrono::hours(1));
    QCOMPARE(first.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
    const std::string refusal = second.open(path(), sampleCase(), sampleCaseText, sampleQuantities);
    QVERIFY2(refusal.find("another run writes to it") != std::string::npos, refusal.c_str());
    QCOMPARE(first.append(sampleBatch(0, 5)), std::string());
    QCOMPARE(first.finish(sampleSummary()), std::string());
    QCOMPARE(readResults(path()).samples.size(), std::size_t{5});
    QCOMPARE(second.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
}

void TestResultsExchange::fileRemovedDuringARun()
{
    ResultsWriter writer(0ms);
    QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
    QCOMPARE(writer.append(sampleBatch(0, 5)), std::string());
    // Once they are in the file, the writer's thread waits for more: it is not on its way to this file.
    QTRY_COMPARE(readResults(path()).samples.size(), std::size_t{5});
    fs::remove(path());
    QCOMPARE(writer.append(sampleBatch(5, 5)).find('\n'), std::string::npos);
    QVERIFY(writer.finish(sampleSummary()).find("removed or replaced") != std::string::npos);
    QVERIFY(fs::is_empty(path().parent_path()));
}

// A limit on the size of files stands in for a full disk: it fails in the same calls, and needs no rights.
void TestResultsExchange::fullDisk()
{
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = 400000;

    ResultsWriter writer(0ms);
    QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
    QCOMPARE(writer.append(sampleBatch(0, 1000)), std::string());
    QTRY_COMPARE(readResults(path()).samples.size(), std::size_t{1000});
    setrlimit(RLIMIT_FSIZE, &small);
    std::string problem;
    std::size_t k = 1000;
    for (; problem.empty() && k < 400000; k += 1000) problem = writer.append(sampleBatch(k, 1000));
    if (problem.empty()) problem = writer.finish(sampleSummary());

    ResultsWriter none;
    rlimit tiny = small;
    tiny.rlim_cur = 1000;
    setrlimit(RLIMIT_FSIZE, &tiny);
    const std::string atOnce = none.open(path("other.h5"), sampleCase(), sampleCaseText, sampleQuantities);
    setrlimit(RLIMIT_FSIZE, &before);

    QVERIFY2(problem.find("File too large") != std::string::npos, problem.c_str());
    QVERIFY2(problem.find("run.h5") != std::string::npos, problem.c_str());
    QVERIFY2(atOnce.find("File too large") != std::string::npos, atOnce.c_str());
    QCOMPARE(QDir(folder_->path()).entryList({"other*"}, QDir::Files), QStringList());
    // The last state that fitted is whole.
    const StoredRun run = readResults(path());
    QCOMPARE(run.problem, std::string());
    QCOMPARE(run.status, std::string("interrupted"));
    QVERIFY(run.samples.size() >= 1000);
    QCOMPARE(wrongSample(run.samples), QString());
}

TOUCHDOWN_TEST(TestResultsExchange)

} // namespace test_results_exchange

#include "test_results_exchange.moc"
