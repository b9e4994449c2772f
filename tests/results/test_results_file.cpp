// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_writer.h"

#include <QtTest>

#include "tests/support/sample_results.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_results_file {

namespace fs = std::filesystem;

class TestResultsFile : public QObject {
    Q_OBJECT

private slots:
    void init();
    void roundTrip_data();
    void roundTrip();
    void statusIsInterruptedWithoutFinish();
    void refusedTarget();
    void samplesThatDoNotFit();

private:
    fs::path path(const char* name = "run.h5") const { return fs::path(folder_->path().toStdString()) / name; }
    std::unique_ptr<QTemporaryDir> folder_;
};

void TestResultsFile::init()
{
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(folder_->isValid());
}

// A chunk has 8192 samples; flushes come wherever they come.
void TestResultsFile::roundTrip_data()
{
    QTest::addColumn<int>("samples");
    QTest::addColumn<int>("step");
    QTest::addColumn<int>("interval");
    QTest::newRow("no samples") << 0 << 1 << 700;
    QTest::newRow("one sample") << 1 << 1 << 700;
    QTest::newRow("one less than a chunk") << 8191 << 8191 << 700;
    QTest::newRow("a chunk") << 8192 << 1000 << 700;
    QTest::newRow("one more than a chunk, one flush") << 8193 << 777 << 700;
    QTest::newRow("many chunks, many flushes") << 100003 << 997 << 0;
    QTest::newRow("early flush, more than may wait") << 3000000 << 300000 << 3600000;
}

void TestResultsFile::roundTrip()
{
    QFETCH(int, samples);
    QFETCH(int, step);
    QFETCH(int, interval);
    const auto n = static_cast<std::size_t>(samples);
    ResultsWriter writer{std::chrono::milliseconds(interval)};
    QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
    for (std::size_t k = 0; k < n; k += static_cast<std::size_t>(step)) {
        QCOMPARE(writer.append(sampleBatch(k, std::min(static_cast<std::size_t>(step), n - k))), std::string());
        QCOMPARE(writer.append({}), std::string());
    }
    QCOMPARE(writer.finish(sampleSummary()), std::string());

    const StoredRun run = readResults(path());
    QCOMPARE(run.problem, std::string());
    QCOMPARE(run.title, sampleCase().title);
    QCOMPARE(run.caseText, sampleCaseText);
    QCOMPARE(run.status, std::string("failed"));
    QCOMPARE(run.message, sampleSummary().message);
    QCOMPARE(run.softwareVersion, std::string(TOUCHDOWN_VERSION));
    QVERIFY(QDateTime::fromString(QString::fromStdString(run.date), Qt::ISODate).isValid());
    QVERIFY(run.date.ends_with('Z'));
    QCOMPARE(run.quantities.size(), sampleQuantities.size());
    for (std::size_t i = 0; i < sampleQuantities.size(); ++i) {
        QCOMPARE(run.quantities[i].name, sampleQuantities[i].name);
        QCOMPARE(run.quantities[i].unit, sampleQuantities[i].unit);
        QCOMPARE(run.quantities[i].displayUnit, sampleQuantities[i].displayUnit);
        QCOMPARE(run.quantities[i].longName, sampleQuantities[i].longName);
    }
    QCOMPARE(run.samples.size(), n);
    QCOMPARE(wrongSample(run.samples), QString());
    QCOMPARE(QDir(folder_->path()).entryList(QDir::Files), QStringList{"run.h5"});
}

void TestResultsFile::statusIsInterruptedWithoutFinish()
{
    {
        ResultsWriter writer;
        QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
        QCOMPARE(writer.append(sampleBatch(0, 1234)), std::string());
    }
    const StoredRun run = readResults(path());
    QCOMPARE(run.problem, std::string());
    QCOMPARE(run.status, std::string("interrupted"));
    QCOMPARE(run.samples.size(), std::size_t{1234});
    QCOMPARE(wrongSample(run.samples), QString());
    QCOMPARE(QDir(folder_->path()).entryList(QDir::Files), QStringList{"run.h5"});
}

void TestResultsFile::refusedTarget()
{
    fs::create_directory(path());
    ResultsWriter writer;
    QVERIFY(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities).find("is a directory") !=
            std::string::npos);
    QVERIFY(!writer.append(sampleBatch(0, 1)).empty());
    QVERIFY(!writer.finish(sampleSummary()).empty());
}

void TestResultsFile::samplesThatDoNotFit()
{
    ResultsWriter writer;
    QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
    SampleBatch narrow = sampleBatch(0, 3);
    narrow.columns.pop_back();
    QVERIFY(writer.append(narrow).find("do not fit") != std::string::npos);
    SampleBatch ragged = sampleBatch(0, 3);
    ragged.columns[1].pop_back();
    QVERIFY(writer.append(ragged).find("do not fit") != std::string::npos);
    QCOMPARE(writer.append(sampleBatch(0, 3)), std::string());
    QCOMPARE(writer.finish(sampleSummary()), std::string());
    QCOMPARE(readResults(path()).samples.size(), std::size_t{3});
}

TOUCHDOWN_TEST(TestResultsFile)

} // namespace test_results_file

#include "test_results_file.moc"
