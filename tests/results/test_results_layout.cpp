// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_layout.h"

#include <cmath>

#include <QtTest>

#include "core/case/parameters.h"
#include "core/formats/hdf5_file.h"
#include "tests/support/sample_results.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_results_layout {

namespace fs = std::filesystem;

class TestResultsLayout : public QObject {
    Q_OBJECT

private slots:
    void init();
    void layout();
    void figuresAndFit();
    void spectra_data();
    void spectra();

private:
    fs::path path(const char* name = "run.h5") const { return fs::path(folder_->path().toStdString()) / name; }
    std::unique_ptr<QTemporaryDir> folder_;
};

void TestResultsLayout::init()
{
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(folder_->isValid());
}

void TestResultsLayout::layout()
{
    ResultsWriter writer;
    QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
    QCOMPARE(writer.append(sampleBatch(0, 10000)), std::string());
    QCOMPARE(writer.finish(sampleSummary()), std::string());

    const Hdf5Access access;
    const Hdf5Group file = openHdf5File(path());
    QCOMPARE(file.attribute("format"), std::string("touchdown-run"));
    QCOMPARE(file.attribute("format_version"), std::string("1.4"));
    const auto number = [&](const char* name) { return file.get(name).numbers().at(0); };
    const auto unit = [&](const char* name) { return file.get(name).attribute("unit"); };
    QCOMPARE(number("case/parameters/springs.cutoff"), 0.4e-9);
    QCOMPARE(unit("case/parameters/springs.cutoff"), std::string("m"));
    QCOMPARE(unit("case/parameters/ono_yamane.friction"), std::string("1"));
    QCOMPARE(file.get("case/parameters/run.integrator").text(), std::string("dopri5"));
    QCOMPARE(number("summary/final/pitch"), 90e-6);
    QCOMPARE(unit("summary/final/pitch"), std::string("rad"));
    QCOMPARE(number("summary/tail/pitch/std"), 1e-9);
    QCOMPARE(number("summary/steps"), 123.0);
    QCOMPARE(number("summary/peaks/frequency"), 8e5);
    QCOMPARE(unit("events/time"), std::string("s"));
    QVERIFY(file.has("events/name"));

    const Hdf5Dataset time = file.get("timeseries/time");
    const Hdf5Dataset pitch = file.get("timeseries/pitch");
    QCOMPARE(pitch.attribute("long_name"), std::string("Pitch"));
    QCOMPARE(time.attribute("CLASS"), std::string("DIMENSION_SCALE"));
    QVERIFY(H5Aexists(pitch, "DIMENSION_LIST") > 0);
    const Hdf5Handle list(H5Dget_create_plist(pitch), H5Pclose);
    QCOMPARE(H5Pget_layout(list), H5D_CHUNKED);
    QCOMPARE(H5Pget_nfilters(list), 2);
    const Hdf5Handle space(H5Dget_space(pitch), H5Sclose);
    hsize_t most = 0;
    H5Sget_simple_extent_dims(space, nullptr, &most);
    QCOMPARE(most, H5S_UNLIMITED);
}

// Of contact cases: what one reads off a run, the fitted parameters, and the seed of the disk.
void TestResultsLayout::figuresAndFit()
{
    Case c = defaultsOf(ModelKind::Contact);
    c.diskSurface.kind = DiskSurfaceKind::Rough;
    c.diskSurface.seed = 42;
    Summary summary = sampleSummary();
    summary.figures = {{{"pull_off_force", "N", "mN", "Pull-off force"}, 5e-6},
                       {{"pull_off_force_error", "N", "mN", "Its error, not known"}, NAN}};
    summary.fit.emplace().parameters.takeOff = 5e-9;
    summary.fit->describes = true;
    ResultsWriter writer;
    QCOMPARE(writer.open(path(), c, "", sampleQuantities), std::string());
    QCOMPARE(writer.finish(summary), std::string());
    const Hdf5Access access;
    const Hdf5Group file = openHdf5File(path());
    const auto number = [&](const char* name) { return file.get(name).numbers().at(0); };
    QCOMPARE(number("summary/figures/pull_off_force"), 5e-6);
    QVERIFY(std::isnan(number("summary/figures/pull_off_force_error")));
    QCOMPARE(file.get("summary/figures/pull_off_force").attribute("unit"), std::string("N"));
    QCOMPARE(number("summary/fit/take_off"), 5e-9);
    QCOMPARE(number("summary/fit/describes"), 1.0);
    QCOMPARE(file.get("summary/fit/take_off_shape").text(), std::string("constant"));
    QCOMPARE(number("case/parameters/disk.surface.seed"), 42.0);
    std::int64_t seed = 0;
    const Hdf5Handle attribute(H5Aopen(file, "seed", H5P_DEFAULT), H5Aclose);
    checkHdf5(H5Aread(attribute, H5T_NATIVE_INT64, &seed));
    QCOMPARE(seed, std::int64_t{42});
}

void TestResultsLayout::spectra_data()
{
    QTest::addColumn<bool>("density");
    QTest::addColumn<QString>("dataset");
    QTest::addColumn<QString>("unit");
    QTest::newRow("density") << true << "density"
                             << "(m)^2/Hz";
    QTest::newRow("amplitude") << false << "power"
                               << "(m)^2";
}

void TestResultsLayout::spectra()
{
    QFETCH(bool, density);
    QFETCH(QString, dataset);
    QFETCH(QString, unit);
    SpectrumCase options;
    options.scaling = density ? SpectrumScaling::Density : SpectrumScaling::Amplitude;
    Spectrum spectrum;
    spectrum.frequency = {0.0, 5e3, 10e3, 15e3};
    spectrum.power = {1e-20, 3e-20, 2e-20, 0.0};
    spectrum.segment = 6;
    spectrum.segments = 4;
    ResultsWriter writer;
    QCOMPARE(writer.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
    QCOMPARE(writer.addSpectrum(sampleQuantities[0], spectrum, options), std::string());
    QCOMPARE(writer.addSpectrum(sampleQuantities[0], spectrum, options), std::string());
    QCOMPARE(writer.addSpectrum(sampleQuantities[1], {}, options), std::string());
    QCOMPARE(writer.finish(sampleSummary()), std::string());

    const Hdf5Access access;
    const Hdf5Group file = openHdf5File(path());
    QVERIFY(!file.has("spectra/pitch"));
    const Hdf5Group group = file.group("spectra/minimum_spacing");
    QCOMPARE(group.attribute("window"), std::string("hann"));
    QCOMPARE(group.attribute("scaling"), std::string(density ? "density" : "amplitude"));
    for (const char* name : {"segment_length", "segment_samples", "segments", "overlap"})
        QVERIFY2(H5Aexists(group, name) > 0, name);
    const Hdf5Dataset power = group.get(dataset.toStdString());
    QCOMPARE(QString::fromStdString(power.attribute("unit")), unit);
    QCOMPARE(power.numbers(), spectrum.power);
    QCOMPARE(group.get("frequency").attribute("unit"), std::string("Hz"));
}

TOUCHDOWN_TEST(TestResultsLayout)

} // namespace test_results_layout

#include "test_results_layout.moc"
