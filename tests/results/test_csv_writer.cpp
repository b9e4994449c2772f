// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/csv_writer.h"

#include <algorithm>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QtTest>

#include "tests/support/file_size_limit.h"
#include "tests/support/sample_results.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_csv_writer {

namespace fs = std::filesystem;

class TestCsvWriter : public QObject {
    Q_OBJECT

private slots:
    void init();
    void csvReadsBackExactly();
    void csvProblems_data();
    void csvProblems();
    void fullDiskKeepsTheOldFile();
    void withoutItsEndThereIsNoFile();
    void aPipeTakesAllSamplesOfItsReader();
    void aPipeThatNobodyReadsIsGivenUpWhenTheRunIsToStop();

private:
    fs::path path(const char* name = "run.h5") const { return fs::path(folder_->path().toStdString()) / name; }
    std::unique_ptr<QTemporaryDir> folder_;
};

void TestCsvWriter::init()
{
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(folder_->isValid());
}

void TestCsvWriter::csvReadsBackExactly()
{
    CsvWriter writer;
    std::vector<Quantity> columns = sampleQuantities;
    columns[1].name = "pitch, of the \"slider\"";
    QCOMPARE(writer.open(path("run.csv"), columns), std::string());
    const std::size_t n = 30000;
    for (std::size_t k = 0; k < n; k += 1000) QCOMPARE(writer.append(sampleBatch(k, 1000)), std::string());
    QCOMPARE(writer.close(), std::string());

    const QList<QByteArray> lines = QByteArray::fromStdString(bytes(path("run.csv"))).split('\n');
    QCOMPARE(lines.size(), static_cast<qsizetype>(n) + 2);
    QCOMPARE(lines.front(), QByteArray("time [s],minimum_spacing [m],\"pitch, of the \"\"slider\"\" [rad]\"\r"));
    QCOMPARE(lines.back(), QByteArray());
    for (std::size_t k = 0; k < n; ++k) {
        const QList<QByteArray> fields = lines[static_cast<qsizetype>(k) + 1].chopped(1).split(',');
        QCOMPARE(fields.size(), 3);
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE(fields[static_cast<qsizetype>(i)].toDouble() == sampleValue(i, k), true);
    }
}

void TestCsvWriter::csvProblems_data()
{
    QTest::addColumn<QString>("target");
    QTest::addColumn<QString>("says");
    QTest::newRow("a directory") << "sub"
                                 << "Is a directory";
    QTest::newRow("in no directory") << "none/run.csv"
                                     << "No such file or directory";
    QTest::newRow("full disk") << "/dev/full"
                               << "No space left on device";
}

void TestCsvWriter::csvProblems()
{
    QFETCH(QString, target);
    QFETCH(QString, says);
    fs::create_directory(path("sub"));
    CsvWriter writer;
    std::string problem = writer.open(path(qPrintable(target)), sampleQuantities);
    if (problem.empty()) problem = writer.append(sampleBatch(0, 100000));
    if (problem.empty()) problem = writer.close();
    QVERIFY2(problem.find(says.toStdString()) != std::string::npos, problem.c_str());
    QVERIFY(problem.find(target.toStdString()) != std::string::npos);
}

void TestCsvWriter::fullDiskKeepsTheOldFile()
{
    std::ofstream(path("run.csv")) << "older results";
    std::string problem;
    {
        const test::FileSizeLimit full(50'000);
        CsvWriter writer;
        QCOMPARE(writer.open(path("run.csv"), sampleQuantities), std::string());
        problem = writer.append(sampleBatch(0, 100'000));
        QVERIFY(!problem.empty());
        QCOMPARE(writer.close(), problem);
    }
    QVERIFY2(problem.find("File too large") != std::string::npos, problem.c_str());
    QCOMPARE(bytes(path("run.csv")), std::string("older results"));
    QCOMPARE(QDir(folder_->path()).entryList(QDir::Files), QStringList{"run.csv"});
}

void TestCsvWriter::withoutItsEndThereIsNoFile()
{
    {
        CsvWriter writer;
        QCOMPARE(writer.open(path("run.csv"), sampleQuantities), std::string());
        QCOMPARE(writer.append(sampleBatch(0, 100'000)), std::string());
    }
    QCOMPARE(QDir(folder_->path()).entryList(QDir::Files), QStringList());
}

/// More than a pipe holds, with a reader that begins late.
void TestCsvWriter::aPipeTakesAllSamplesOfItsReader()
{
    QCOMPARE(::mkfifo(path("pipe").c_str(), 0600), 0);
    std::string taken;
    std::jthread reader;
    CsvWriter writer;
    const auto begin = [&] { // when the writer has found none
        if (!reader.joinable()) reader = std::jthread([&] { taken = bytes(path("pipe")); });
        return true;
    };
    QCOMPARE(writer.open(path("pipe"), sampleQuantities, begin), std::string());
    for (std::size_t k = 0; k < 30'000; k += 1000) QCOMPARE(writer.append(sampleBatch(k, 1000)), std::string());
    QCOMPARE(writer.close(), std::string());
    reader.join();
    QCOMPARE(std::ranges::count(taken, '\n'), 30'001);
}

void TestCsvWriter::aPipeThatNobodyReadsIsGivenUpWhenTheRunIsToStop()
{
    QCOMPARE(::mkfifo(path("pipe").c_str(), 0600), 0);
    const auto stop = [] { return false; };
    const std::string problem = CsvWriter().open(path("pipe"), sampleQuantities, stop);
    QVERIFY2(problem.find("no program reads it") != std::string::npos, problem.c_str());
    const int idle = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC); // it takes nothing
    CsvWriter writer;
    QCOMPARE(writer.open(path("pipe"), sampleQuantities, stop), std::string());
    QCOMPARE(writer.append(sampleBatch(0, 30'000)), problem);
    ::close(idle);
}

TOUCHDOWN_TEST(TestCsvWriter)

} // namespace test_csv_writer

#include "test_csv_writer.moc"
