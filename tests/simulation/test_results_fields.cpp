// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/results_fields.h"

#include <QtTest>

#include "core/simulation/results_exchange.h"
#include "tests/support/sample_results.h"

using namespace touchdown;
namespace fs = std::filesystem;

namespace {

/// 3 x 2 cells of different widths.
RecordedFields someFields()
{
    return {{{0.0, 1e-6, 3e-6, 4e-6}, {-1e-6, 0.0, 2e-6}},
            {{"gap", "m", "nm", "Gap"}, {"contact_pressure", "Pa", "MPa", "Contact pressure"}}};
}

/// Value of cell i of field f in snapshot k.
double value(std::size_t k, std::size_t f, std::size_t i)
{
    return std::sin(static_cast<double>(1 + k * 31 + f * 7 + i)) * (f == 0 ? 1e-9 : 1e8);
}

std::vector<FieldSnapshot> snapshots(std::size_t first, std::size_t count, const RecordedFields& fields)
{
    std::vector<FieldSnapshot> list;
    for (std::size_t k = first; k < first + count; ++k) {
        FieldSnapshot snapshot{static_cast<double>(k) * 1e-5, 0, {}};
        for (std::size_t f = 0; f < fields.quantities.size(); ++f) {
            std::vector<double> values;
            for (std::size_t i = 0; i < fields.grid.cells(); ++i) values.push_back(value(k, f, i));
            snapshot.values.push_back(std::move(values));
        }
        list.push_back(std::move(snapshot));
    }
    return list;
}

} // namespace

class TestResultsFields : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        folder_ = std::make_unique<QTemporaryDir>();
        QVERIFY(folder_->isValid());
    }

    void roundTrip_data()
    {
        QTest::addColumn<int>("flushes");
        QTest::addColumn<int>("eachTime");
        QTest::newRow("none") << 1 << 0;
        QTest::newRow("one") << 1 << 1;
        // Each flush brings the older of two files up to date.
        QTest::newRow("many flushes") << 7 << 3;
    }
    void roundTrip()
    {
        QFETCH(int, flushes);
        QFETCH(int, eachTime);
        const RecordedFields fields = someFields();
        ResultsExchange exchange(path(), {sampleCase(), sampleCaseText, dateNow(), sampleQuantities, fields});
        for (int i = 0; i < flushes; ++i)
            exchange.publish(
                sampleBatch(static_cast<std::size_t>(i) * 10, 10),
                snapshots(static_cast<std::size_t>(i * eachTime), static_cast<std::size_t>(eachTime), fields));
        const StoredRun run = readResults(path());
        QCOMPARE(run.problem, std::string());
        QCOMPARE(run.recorded.grid.x, fields.grid.x);
        QCOMPARE(run.recorded.grid.y, fields.grid.y);
        QCOMPARE(run.recorded.quantities.size(), fields.quantities.size());
        for (std::size_t i = 0; i < fields.quantities.size(); ++i) {
            QCOMPARE(run.recorded.quantities[i].name, fields.quantities[i].name);
            QCOMPARE(run.recorded.quantities[i].displayUnit, fields.quantities[i].displayUnit);
        }
        const auto expected = snapshots(0, static_cast<std::size_t>(flushes * eachTime), fields);
        QCOMPARE(run.fields.size(), expected.size());
        for (std::size_t k = 0; k < expected.size(); ++k) {
            QCOMPARE(run.fields[k].time, expected[k].time);
            QCOMPARE(run.fields[k].values, expected[k].values);
        }
    }

    /// What other programs look for: dimension scales at the cells' centres.
    void layout()
    {
        const RecordedFields fields = someFields();
        ResultsWriter writer;
        QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities, fields), std::string());
        QCOMPARE(writer.append(sampleBatch(0, 3), snapshots(0, 2, fields)), std::string());
        QCOMPARE(writer.finish(sampleSummary()), std::string());
        const Hdf5Access access;
        const Hdf5Handle file(H5Fopen(path().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
        const Hdf5Handle gap = openHdf5Dataset(file, "fields/gap");
        const Hdf5Handle space(H5Dget_space(gap), H5Sclose);
        hsize_t extent[3] = {};
        QCOMPARE(H5Sget_simple_extent_dims(space, extent, nullptr), 3);
        QCOMPARE(extent[0], hsize_t{2});
        QCOMPARE(extent[1], hsize_t{2}); // y
        QCOMPARE(extent[2], hsize_t{3}); // x
        QVERIFY(H5Aexists(gap, "DIMENSION_LIST") > 0);
        QCOMPARE(readHdf5Attribute(gap, "unit"), std::string("m"));
        double x[3] = {};
        const Hdf5Handle scale = openHdf5Dataset(file, "fields/x");
        checkHdf5(H5Dread(scale, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, x));
        QCOMPARE(x[0], 0.5e-6);
        QCOMPARE(x[1], 2e-6);
        QCOMPARE(readHdf5Attribute(scale, "CLASS"), std::string("DIMENSION_SCALE"));
        const Hdf5Handle list(H5Dget_create_plist(gap), H5Pclose);
        QCOMPARE(H5Pget_layout(list), H5D_CHUNKED);
        QCOMPARE(H5Pget_nfilters(list), 2);
    }

    void snapshotsThatDoNotFit()
    {
        ResultsWriter writer;
        QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities, someFields()), std::string());
        QVERIFY(writer.append(sampleBatch(0, 1), {{0.0, {{1.0, 2.0}}}}).find("do not fit the grid") !=
                std::string::npos);
        QCOMPARE(writer.append(sampleBatch(0, 3)), std::string());
        QCOMPARE(writer.finish(sampleSummary()), std::string());
        QCOMPARE(readResults(path()).samples.size(), std::size_t{3});
    }

    void runsWithoutFields()
    {
        ResultsWriter writer;
        QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
        QCOMPARE(writer.append(sampleBatch(0, 3)), std::string());
        QCOMPARE(writer.finish(sampleSummary()), std::string());
        const StoredRun run = readResults(path());
        QVERIFY(run.recorded.empty());
        QVERIFY(run.fields.empty());
    }

private:
    fs::path path() const { return fs::path(folder_->path().toStdString()) / "run.h5"; }
    std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(TestResultsFields)
#include "test_results_fields.moc"
