// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/steady_writer.h"

#include "core/formats/hdf5_file.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <hdf5_hl.h>
#include <limits>
#include <memory>

using namespace touchdown;

namespace test_steady_writer {

using test::sampleFilmCase;
using test::sampleSteady;

const std::string caseText = "model = \"film\" # µ\n";
const SteadySeriesPoint onePoint{23e-3, 0.1, 565.0, {}};

/// To round-off.
bool same(const std::vector<double>& a, const std::vector<double>& b)
{
    return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) <= 1e-14 * std::abs(y); });
}

class Reader {
public:
    explicit Reader(const std::filesystem::path& path) : file_(openHdf5File(path)) {}
    bool has(const std::string& name) const { return H5LTpath_valid(file_, name.c_str(), true) > 0; }
    std::vector<double> numbers(const std::string& name) const { return file_.get(name).numbers(); }
    std::vector<hsize_t> shape(const std::string& name) const { return file_.get(name).shape(); }
    std::string attribute(const std::string& object, const char* name) const
    {
        return Hdf5Object(H5Oopen(file_, object.c_str(), H5P_DEFAULT), H5Oclose).attribute(name);
    }
    bool isOn(const std::string& field, unsigned dimension, const std::string& scale) const
    {
        return H5DSis_attached(file_.get(field), file_.get(scale), dimension) > 0;
    }
    std::string text(const std::string& name) const { return file_.get(name).text(); }

private:
    Hdf5Access access_;
    Hdf5Group file_;
};

class TestSteadyWriter : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void oneState()
    {
        SteadyWriter writer;
        QCOMPARE(writer.open(path(), sampleFilmCase(), caseText), std::string());
        QCOMPARE(writer.add(onePoint, sampleSteady()), std::string());
        QVERIFY(!QFile::exists(path().c_str())); // it gets its name when it is whole
        QCOMPARE(writer.finish(SteadyStatus::Converged, "well"), std::string());
        QCOMPARE(QDir(folder_->path()).entryList(QDir::Files), QStringList("a.h5"));

        const Reader file(path());
        QCOMPARE(file.attribute("/", "format"), std::string("touchdown-steady"));
        QCOMPARE(file.attribute("/", "format_version"), std::string("1.2"));
        QCOMPARE(file.attribute("/", "software_version"), std::string(TOUCHDOWN_VERSION));
        QCOMPARE(file.attribute("/", "title"), std::string("A plane"));
        QCOMPARE(file.attribute("/", "status"), std::string("converged"));
        QCOMPARE(file.attribute("/", "message"), std::string("well"));
        QVERIFY(QDateTime::fromString(file.attribute("/", "date").c_str(), Qt::ISODate).isValid());
        QCOMPARE(file.text("/case/text"), caseText);
        QCOMPARE(file.numbers("/case/parameters/film.nodes"), (std::vector<double>{193, 193}));
        QVERIFY(!file.has("/case/parameters/springs.cutoff"));
        QVERIFY(!file.has("/series"));

        const SteadyResult r = sampleSteady();
        QCOMPARE(file.attribute("/states/1", "status"), std::string("converged"));
        for (const auto& [quantity, value] : steadyQuantities(r)) {
            const std::string name = "/states/1/" + quantity.name;
            QCOMPARE(file.numbers(name), std::vector<double>{value});
            QCOMPARE(file.attribute(name, "unit"), quantity.unit);
            QCOMPARE(file.attribute(name, "long_name"), quantity.longName);
        }
        QCOMPARE(file.numbers("/states/1/minimum_spacing_at"), (std::vector<double>{1.24e-3, 0.9e-3}));
        QCOMPARE(file.numbers("/states/1/centre_of_negative_pressure"), (std::vector<double>{0.6e-3, 0.52e-3}));
        QCOMPARE(file.shape("/states/1/stiffness"), (std::vector<hsize_t>{3, 3}));
        QCOMPARE(file.numbers("/states/1/stiffness"),
                 (std::vector<double>{1e5, 2.0, 3.0, 4.0, 5e-3, 6e-4, 7.0, 8e-4, 9e-3}));
        QCOMPARE(file.numbers("/states/1/points_of_interest"),
                 (std::vector<double>{1.2e-3, 0.5e-3, 11e-9, 0.1e-3, 0.2e-3, 180e-9}));
        QCOMPARE(file.numbers("/states/1/sensitivities/abs.crown"), (std::vector<double>{0.1, 2e3, 3.0, 0.4}));
    }

    void fieldsStandOnTheirAxes()
    {
        writeOne(sampleSteady());
        const Reader file(path());
        // Centres of 0, 0.5, 1.0, 1.25 mm and of 0, 0.4, 1.0 mm.
        const auto x = file.numbers("/states/1/fields/x");
        const auto y = file.numbers("/states/1/fields/y");
        QVERIFY(same(x, {0.25e-3, 0.75e-3, 1.125e-3}));
        QVERIFY(same(y, {0.2e-3, 0.7e-3}));
        QCOMPARE(file.numbers("/states/1/fields/x_lines"), sampleSteady().grid.x);
        QCOMPARE(file.numbers("/states/1/fields/y_lines"), sampleSteady().grid.y);
        for (const char* name : {"pressure", "gap", "recess"}) {
            const std::string field = std::string("/states/1/fields/") + name;
            QCOMPARE(file.shape(field), (std::vector<hsize_t>{2, 3}));
            QVERIFY(file.isOn(field, 0, "/states/1/fields/y"));
            QVERIFY(file.isOn(field, 1, "/states/1/fields/x"));
        }
        // Row by row: y outer.
        QCOMPARE(file.numbers("/states/1/fields/pressure"),
                 (std::vector<double>{100000, 100001, 100002, 100010, 100011, 100012}));
        QCOMPARE(file.attribute("/states/1/fields/pressure", "unit"), std::string("Pa"));
        QCOMPARE(file.attribute("/states/1/fields/gap", "unit"), std::string("m"));
    }

    void aSeriesHasItsColumns()
    {
        SteadyWriter writer;
        QCOMPARE(writer.open(path(), sampleFilmCase(), caseText), std::string());
        SteadyResult result = sampleSteady();
        for (int i = 0; i < 3; ++i) {
            result.minimumSpacing = (5 + i) * 1e-9;
            QCOMPARE(writer.add({(20 + i) * 1e-3, 0.1, 565.0, 1000.0 * i}, result), std::string());
        }
        QCOMPARE(writer.finish(SteadyStatus::NotConverged, "the last one"), std::string());
        const Reader file(path());
        QVERIFY(same(file.numbers("/series/radius"), {20e-3, 21e-3, 22e-3}));
        QCOMPARE(file.numbers("/series/altitude"), (std::vector<double>{0.0, 1000.0, 2000.0}));
        QVERIFY(same(file.numbers("/series/minimum_spacing"), {5e-9, 6e-9, 7e-9}));
        QCOMPARE(file.attribute("/series/minimum_spacing", "unit"), std::string("m"));
        QVERIFY(same(file.numbers("/states/3/minimum_spacing"), {7e-9}));
        QCOMPARE(file.attribute("/", "status"), std::string("not converged"));
    }

    /// What a failed solve did not find is missing or NaN, never made up.
    void aFailedState()
    {
        SteadyResult failed;
        failed.status = SteadyStatus::Failed;
        failed.message = "no balance";
        failed.minimumSpacing = std::numeric_limits<double>::quiet_NaN();
        writeOne(failed);
        const Reader file(path());
        QCOMPARE(file.attribute("/states/1", "message"), std::string("no balance"));
        QVERIFY(std::isnan(file.numbers("/states/1/minimum_spacing").at(0)));
        QVERIFY(!file.has("/states/1/fields"));
        QVERIFY(!file.has("/states/1/stiffness"));
        QVERIFY(!file.has("/states/1/points_of_interest"));
    }

    void whatIsNotFinishedLeavesNothing()
    {
        QFile old(path().c_str());
        QVERIFY(old.open(QIODevice::WriteOnly));
        old.write("precious");
        old.close();
        {
            SteadyWriter writer;
            QCOMPARE(writer.open(path(), sampleFilmCase(), caseText), std::string());
            QCOMPARE(writer.add(onePoint, sampleSteady()), std::string());
        }
        QCOMPARE(QDir(folder_->path()).entryList(QDir::Files), QStringList("a.h5"));
        QVERIFY(old.open(QIODevice::ReadOnly));
        QCOMPARE(old.readAll(), QByteArray("precious"));
    }
    void refusesWhatCannotBeWritten()
    {
        SteadyWriter writer;
        const std::string nowhere = path().parent_path() / "no folder" / "a.h5";
        QVERIFY(
            QString::fromStdString(writer.open(nowhere, sampleFilmCase(), caseText)).contains("there is no directory"));
        QCOMPARE(writer.add(onePoint, sampleSteady()), std::string("no results file is open"));
        QCOMPARE(writer.finish(SteadyStatus::Converged, ""), std::string("no results file is open"));
    }

private:
    std::filesystem::path path() const { return std::filesystem::path(folder_->path().toStdString()) / "a.h5"; }
    void writeOne(const SteadyResult& result) const
    {
        SteadyWriter writer;
        QCOMPARE(writer.open(path(), sampleFilmCase(), caseText), std::string());
        QCOMPARE(writer.add(onePoint, result), std::string());
        QCOMPARE(writer.finish(result.status, result.message), std::string());
    }
    std::unique_ptr<QTemporaryDir> folder_;
};

TOUCHDOWN_TEST(TestSteadyWriter)

} // namespace test_steady_writer

#include "test_steady_writer.moc"
