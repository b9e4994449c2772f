// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_reader.h"

#include <QtTest>

#include "core/formats/hdf5_file.h"
#include "tests/support/sample_results.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_results_reader {

namespace fs = std::filesystem;

class TestResultsReader : public QObject {
    Q_OBJECT

private slots:
    void init();
    void unreadableFiles_data();
    void unreadableFiles();

private:
    fs::path path(const char* name = "run.h5") const { return fs::path(folder_->path().toStdString()) / name; }
    std::unique_ptr<QTemporaryDir> folder_;
};

void TestResultsReader::init()
{
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(folder_->isValid());
}

void TestResultsReader::unreadableFiles_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("says");
    QTest::newRow("missing") << "missing"
                             << "there is no such file";
    QTest::newRow("a directory") << "directory"
                                 << "is a directory";
    QTest::newRow("empty") << "empty"
                           << "is not an HDF5 file";
    QTest::newRow("text") << "text"
                          << "is not an HDF5 file";
    QTest::newRow("cut in half") << "half"
                                 << "damaged or cut short";
    QTest::newRow("cut by a byte") << "byte"
                                   << "damaged or cut short";
    QTest::newRow("other HDF5") << "other"
                                << "not the results of a run";
    QTest::newRow("higher major version") << "2.0"
                                          << "has format version 2.0, written by Touchdown";
    QTest::newRow("version that is none") << "x"
                                          << "does not say the version";
    QTest::newRow("columns of different length") << "ragged"
                                                 << "differ in length";
    QTest::newRow("a column that claims too much") << "claim"
                                                   << "fewer numbers than it says";
}

void TestResultsReader::unreadableFiles()
{
    QFETCH(QString, kind);
    QFETCH(QString, says);
    ResultsWriter writer;
    QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
    QCOMPARE(writer.append(sampleBatch(0, 5000)), std::string());
    QCOMPARE(writer.finish(sampleSummary()), std::string());
    const std::string whole = bytes(path());
    {
        const Hdf5Access access;
        const Hdf5Group file = openHdf5File(path(), H5F_ACC_RDWR);
        const Hdf5Dataset pitch = file.get("timeseries/pitch");
        const hsize_t more = 5001;
        const hsize_t far = hsize_t{1} << 40;
        if (kind == "2.0" || kind == "x") file.set("format_version", kind.toStdString());
        if (kind == "ragged") checkHdf5(H5Dset_extent(pitch, &more));
        if (kind == "claim") checkHdf5(H5Dset_extent(pitch, &far));
    }
    if (kind == "missing") fs::remove(path());
    if (kind == "empty") put(path(), "");
    if (kind == "text") put(path(), "time [s],pitch [rad]\n");
    if (kind == "half") put(path(), whole.substr(0, whole.size() / 2));
    if (kind == "byte") put(path(), whole.substr(0, whole.size() - 1));
    if (kind == "directory" || kind == "other") fs::remove(path());
    if (kind == "directory") fs::create_directory(path());
    if (kind == "other") {
        const Hdf5Access access;
        createHdf5File(path());
    }
    const StoredRun run = readResults(path());
    QVERIFY2(run.problem.find(says.toStdString()) != std::string::npos, run.problem.c_str());
    QVERIFY(run.problem.find("run.h5") != std::string::npos);
    QCOMPARE(run.problem.find('\n'), std::string::npos);
    QVERIFY(run.samples.time.empty() && run.quantities.empty() && run.title.empty());
}

TOUCHDOWN_TEST(TestResultsReader)

} // namespace test_results_reader

#include "test_results_reader.moc"
