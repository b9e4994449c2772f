// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_samples.h"

#include <QtTest>

#include "core/formats/hdf5_file.h"
#include "core/results/file_header.h"
#include "core/results/results_exchange.h"
#include "tests/support/sample_results.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_results_samples {

namespace fs = std::filesystem;

/// 3 x 2 cells of different widths.
RecordedFields someFields()
{
    return {"fields",
            {{0.0, 1e-6, 3e-6, 4e-6}, {-1e-6, 0.0, 2e-6}},
            {{"gap", "m", "nm", "Gap"}, {"contact_pressure", "Pa", "MPa", "Contact pressure"}}};
}

/// A film over 3 x 2 cells, a contact over 1 x 4.
std::vector<RecordedFields> twoSets()
{
    return {
        someFields(),
        {"contact_fields", {{1e-6, 2e-6}, {0.0, 1e-6, 2e-6, 3e-6, 4e-6}}, {{"gap", "m", "nm", "Gap of the contact"}}}};
}

/// Value of cell i of field f in snapshot k of set s.
double value(std::size_t s, std::size_t k, std::size_t f, std::size_t i)
{
    return std::sin(static_cast<double>(1 + s * 101 + k * 31 + f * 7 + i)) * (f == 0 ? 1e-9 : 1e8);
}

FieldSnapshot snapshotOf(const std::vector<RecordedFields>& sets, std::size_t set, std::size_t k)
{
    FieldSnapshot snapshot{static_cast<double>(k) * 1e-5, set, {}};
    for (std::size_t f = 0; f < sets[set].quantities.size(); ++f) {
        std::vector<double> values;
        for (std::size_t i = 0; i < sets[set].grid.cells(); ++i) values.push_back(value(set, k, f, i));
        snapshot.values.push_back(std::move(values));
    }
    return snapshot;
}

/// Of each set; of the second at every other time only.
std::vector<FieldSnapshot> snapshots(std::size_t first, std::size_t count, const std::vector<RecordedFields>& sets)
{
    std::vector<FieldSnapshot> list;
    for (std::size_t k = first; k < first + count; ++k)
        for (std::size_t set = 0; set < sets.size(); ++set)
            if (set == 0 || k % 2 == 0) list.push_back(snapshotOf(sets, set, k));
    return list;
}

/// "" if both are the same, each number exact.
QString difference(const StoredRun& run, const std::vector<RecordedFields>& sets,
                   const std::vector<FieldSnapshot>& expected)
{
    if (!run.problem.empty()) return QString::fromStdString(run.problem);
    if (run.recorded.size() != sets.size()) return QStringLiteral("number of sets");
    for (std::size_t s = 0; s < sets.size(); ++s) {
        const RecordedFields& read = run.recorded[s];
        if (read.group != sets[s].group || read.grid.x != sets[s].grid.x || read.grid.y != sets[s].grid.y)
            return QStringLiteral("group or grid of set %1").arg(s);
        if (read.quantities.size() != sets[s].quantities.size()) return QStringLiteral("fields of set %1").arg(s);
        for (std::size_t i = 0; i < read.quantities.size(); ++i)
            if (read.quantities[i].name != sets[s].quantities[i].name ||
                read.quantities[i].displayUnit != sets[s].quantities[i].displayUnit)
                return QStringLiteral("field %1 of set %2").arg(i).arg(s);
    }
    if (run.fields.size() != expected.size()) return QStringLiteral("%1 snapshots").arg(run.fields.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
        if (run.fields[k].time != expected[k].time || run.fields[k].set != expected[k].set ||
            run.fields[k].values != expected[k].values)
            return QStringLiteral("snapshot %1").arg(k);
    return {};
}

class TestResultsSamples : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        folder_ = std::make_unique<QTemporaryDir>();
        QVERIFY(folder_->isValid());
    }

    void roundTrip_data()
    {
        QTest::addColumn<int>("sets");
        QTest::addColumn<int>("flushes");
        QTest::addColumn<int>("eachTime");
        QTest::newRow("none") << 1 << 1 << 0;
        QTest::newRow("one") << 1 << 1 << 1;
        // Each flush brings the older of two files up to date.
        QTest::newRow("many flushes") << 1 << 7 << 3;
        QTest::newRow("two sets, none") << 2 << 1 << 0;
        QTest::newRow("two sets, one of the first alone") << 2 << 3 << 1;
        QTest::newRow("two sets, many flushes") << 2 << 7 << 3;
    }
    void roundTrip()
    {
        QFETCH(int, sets);
        QFETCH(int, flushes);
        QFETCH(int, eachTime);
        std::vector<RecordedFields> fields = twoSets();
        fields.resize(static_cast<std::size_t>(sets));
        ResultsExchange exchange(path(), {sampleCase(), sampleCaseText, dateNow(), sampleQuantities, fields});
        for (int i = 0; i < flushes; ++i)
            exchange.publish(
                sampleBatch(static_cast<std::size_t>(i) * 10, 10),
                snapshots(static_cast<std::size_t>(i * eachTime), static_cast<std::size_t>(eachTime), fields));
        const auto expected = snapshots(0, static_cast<std::size_t>(flushes * eachTime), fields);
        QCOMPARE(difference(readResults(path()), fields, expected), QString());
        // What a run that is killed now leaves behind, on another path.
        fs::copy_file(path(), fs::path(folder_->path().toStdString()) / "copy.h5");
        QCOMPARE(difference(readResults(fs::path(folder_->path().toStdString()) / "copy.h5"), fields, expected),
                 QString());
    }

    /// A run that is never finished keeps what came to it, in both sets, and so does a new one over its file.
    void interruptedRuns()
    {
        const std::vector<RecordedFields> sets = twoSets();
        for (const std::size_t count : {5U, 2U}) {
            {
                ResultsWriter writer;
                QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities, sets), std::string());
                QCOMPARE(writer.append(sampleBatch(0, 3), snapshots(0, count, sets)), std::string());
            }
            const StoredRun run = readResults(path());
            QCOMPARE(run.status, std::string("interrupted"));
            QCOMPARE(difference(run, sets, snapshots(0, count, sets)), QString());
        }
    }

    /// Sets may come one after the other; a reader finds them in the order of time, the first set first.
    void snapshotsInTheOrderOfTime()
    {
        const std::vector<RecordedFields> sets = twoSets();
        ResultsWriter writer;
        QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities, sets), std::string());
        std::vector<FieldSnapshot> apart;
        for (const std::size_t set : {1U, 0U})
            for (const std::size_t k : {0U, 2U, 4U}) apart.push_back(snapshotOf(sets, set, k));
        QCOMPARE(writer.append(sampleBatch(0, 3), apart), std::string());
        QCOMPARE(writer.finish(sampleSummary()), std::string());
        std::vector<FieldSnapshot> expected;
        for (const std::size_t k : {0U, 2U, 4U})
            for (const std::size_t set : {0U, 1U}) expected.push_back(snapshotOf(sets, set, k));
        QCOMPARE(difference(readResults(path()), sets, expected), QString());
    }

    /// Files of version 1.1 keep no order of their groups, and have one set.
    void filesBeforeTheSecondSet()
    {
        const std::vector<RecordedFields> sets{someFields()};
        {
            const Hdf5Access access;
            const Hdf5Group file(H5Fcreate(path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
            writeFileHeader(file, "touchdown-run", 1, 1, dateNow(), "Old");
            file.set("status", "completed");
            writeCaseGroup(file, sampleCase(), sampleCaseText);
            createSamples(file, {}, sets);
            appendSnapshots(file, sets, snapshots(0, 3, sets));
        }
        QCOMPARE(difference(readResults(path()), sets, snapshots(0, 3, sets)), QString());
    }

    /// What other programs look for: dimension scales at the cells' centres.
    void layout()
    {
        const std::vector<RecordedFields> fields = twoSets();
        ResultsWriter writer;
        QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities, fields), std::string());
        QCOMPARE(writer.append(sampleBatch(0, 3), snapshots(0, 3, fields)), std::string());
        QCOMPARE(writer.finish(sampleSummary()), std::string());
        const Hdf5Access access;
        const Hdf5Group file = openHdf5File(path());
        const Hdf5Dataset gap = file.get("fields/gap");
        QCOMPARE(gap.shape(), (std::vector<hsize_t>{3, 2, 3})); // time, y, x
        const Hdf5Dataset contactGap = file.get("contact_fields/gap");
        QCOMPARE(contactGap.shape(), (std::vector<hsize_t>{2, 4, 1})); // of times 0 and 2
        QCOMPARE(contactGap.attribute("long_name"), std::string("Gap of the contact"));
        QVERIFY(H5Aexists(contactGap, "DIMENSION_LIST") > 0);
        QVERIFY(H5Aexists(gap, "DIMENSION_LIST") > 0);
        QCOMPARE(gap.attribute("unit"), std::string("m"));
        const Hdf5Dataset scale = file.get("fields/x");
        const std::vector<double> x = scale.column();
        QCOMPARE(x[0], 0.5e-6);
        QCOMPARE(x[1], 2e-6);
        QCOMPARE(scale.attribute("CLASS"), std::string("DIMENSION_SCALE"));
        const Hdf5Handle list(H5Dget_create_plist(gap), H5Pclose);
        QCOMPARE(H5Pget_layout(list), H5D_CHUNKED);
        QCOMPARE(H5Pget_nfilters(list), 2);
    }

    void snapshotsThatDoNotFit()
    {
        ResultsWriter writer;
        QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities, {someFields()}), std::string());
        const FieldSnapshot tooFewValues{0.0, 0, {{1.0, 2.0}, {1.0, 2.0}}};
        const FieldSnapshot tooFewFields{0.0, 0, {std::vector<double>(6)}};
        const FieldSnapshot ofNoSet{0.0, 1, {std::vector<double>(6), std::vector<double>(6)}};
        for (const FieldSnapshot& wrong : {tooFewValues, tooFewFields, ofNoSet})
            QVERIFY(writer.append(sampleBatch(0, 1), {wrong}).find("do not fit the grid") != std::string::npos);
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

TOUCHDOWN_TEST(TestResultsSamples)

} // namespace test_results_samples

#include "test_results_samples.moc"
