// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/disk_surface_check.h"

#include <QTest>

#include <functional>
#include <limits>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_disk_surface_check {

/// All parts, each without fault.
DiskSurface combined()
{
    DiskSurface s;
    s.kind = DiskSurfaceKind::Combined;
    s.waveAmplitudes = {1e-9, 2e-9};
    s.waveLengths = {50e-6, 70e-6};
    s.bumpHeights = {5e-9};
    s.bumpLengths = {4e-6};
    s.bumpX = {10e-6};
    s.bumpY = {16e-6};
    s.file = "track.txt";
    return s;
}

DiskSurface only(DiskSurfaceKind kind)
{
    DiskSurface s;
    s.kind = kind;
    return s;
}

std::string text(const std::vector<DiskSurfaceProblem>& problems)
{
    std::string all;
    for (const auto& p : problems) all += (all.empty() ? "" : " | ") + p.key + " " + p.sentence;
    return all;
}

class TestDiskSurfaceCheck : public QObject {
    Q_OBJECT

private slots:
    void whatIsMeantIsNoProblem_data()
    {
        QTest::addColumn<std::function<void(DiskSurface&)>>("change");
        const auto row = [](const char* name, std::function<void(DiskSurface&)> change) {
            QTest::newRow(name) << change;
        };
        row("all parts", [](DiskSurface&) {});
        row("flat, whatever else it says", [](DiskSurface& s) {
            s = {};
            s.rms = -1.0;
            s.waveLengths = {0.0};
        });
        row("flat, without a track", [](DiskSurface& s) {
            s = {};
            s.track = s.trackWidth = s.cell = std::numeric_limits<double>::quiet_NaN();
        });
        row("rough as it comes", [](DiskSurface& s) { s = only(DiskSurfaceKind::Rough); });
        row("self-affine as it comes", [](DiskSurface& s) {
            s = only(DiskSurfaceKind::Rough);
            s.spectrum = RoughnessSpectrum::SelfAffine;
        });
        row("angles and phases", [](DiskSurface& s) { s.waveAngles = s.wavePhases = {0.1, 0.2}; });
        row("combined without roughness", [](DiskSurface& s) { s.rms = 0.0; });
        row("correlation of one cell", [](DiskSurface& s) { s.correlationLength = s.cell; });
        row("cut-off of two cells", [](DiskSurface& s) {
            s.spectrum = RoughnessSpectrum::SelfAffine;
            s.cutOff = 2.0 * s.cell;
        });
        row("a cell that is no binary fraction", [](DiskSurface& s) {
            s.cell = 0.1e-6;
            s.track = 0.7e-3;
            s.trackWidth = 30e-6;
        });
        row("10 mm of track", [](DiskSurface& s) { s.track = 10e-3; });
    }
    void whatIsMeantIsNoProblem()
    {
        QFETCH(std::function<void(DiskSurface&)>, change);
        DiskSurface s = combined();
        change(s);
        QCOMPARE(text(diskSurfaceProblems(s)), std::string());
    }

    void eachFaultIsOneSentence_data()
    {
        QTest::addColumn<std::function<void(DiskSurface&)>>("change");
        QTest::addColumn<QByteArray>("sentence");
        const auto row = [](const char* name, std::function<void(DiskSurface&)> change, const char* sentence) {
            QTest::newRow(name) << change << QByteArray(sentence);
        };
        const auto selfAffine = [](DiskSurface& s) { s.spectrum = RoughnessSpectrum::SelfAffine; };

        row(
            "no waves", [](DiskSurface& s) { s = only(DiskSurfaceKind::Waves); },
            "wave_amplitudes must name at least one wave");
        row(
            "fewer lengths than waves", [](DiskSurface& s) { s.waveLengths.pop_back(); },
            "wave_lengths must be as long as wave_amplitudes: 2, not 1");
        row(
            "more angles than waves",
            [](DiskSurface& s) {
                s.waveAngles = {0, 0, 0};
            },
            "wave_angles must be as long as wave_amplitudes, or empty: 2, not 3");
        row(
            "one phase for two waves", [](DiskSurface& s) { s.wavePhases = {0}; },
            "wave_phases must be as long as wave_amplitudes, or empty: 2, not 1");
        row(
            "a wave of no length", [](DiskSurface& s) { s.waveLengths[1] = 0.0; }, "wave_lengths must all be above 0");
        row(
            "an amplitude that is no number",
            [](DiskSurface& s) { s.waveAmplitudes[0] = std::numeric_limits<double>::quiet_NaN(); },
            "wave_amplitudes must all be finite");

        row(
            "waves on a track of no length",
            [](DiskSurface& s) {
                s = only(DiskSurfaceKind::Waves);
                s.waveAmplitudes = {1e-9};
                s.waveLengths = {5e-6};
                s.track = 0.0;
            },
            "track must be above 0");
        row(
            "waves seen at no points",
            [](DiskSurface& s) {
                s = only(DiskSurfaceKind::Waves);
                s.waveAmplitudes = {1e-9};
                s.waveLengths = {5e-6};
                s.cell = std::numeric_limits<double>::quiet_NaN();
            },
            "cell must be above 0");
        row(
            "bumps seen at no points",
            [](DiskSurface& s) {
                s.rms = 0.0;
                s.cell = 0.0;
            },
            "cell must be above 0");
        row(
            "rough without height",
            [](DiskSurface& s) {
                s = only(DiskSurfaceKind::Rough);
                s.rms = 0.0;
            },
            "rms must be above 0 where the disk is rough");
        row(
            "negative roughness", [](DiskSurface& s) { s.rms = -1e-9; }, "rms must be above 0 where the disk is rough");
        row(
            "correlation below the grid step", [](DiskSurface& s) { s.correlationLength = 0.2e-6; },
            "correlation_length must be at least 0.25 um, one cell of the map");
        row(
            "no correlation length", [](DiskSurface& s) { s.correlationLength = 0.0; },
            "correlation_length must be above 0");
        row(
            "a track that forgets nothing", [](DiskSurface& s) { s.correlationLength = 5e-6; },
            "track_width must be at least 40 um, eight correlation lengths");
        row(
            "no whole number of cells", [](DiskSurface& s) { s.track = 1000.1e-6; },
            "track must be a whole multiple of the map's cell of 0.25 um, for example 1000 um");
        row(
            "no whole number of cells across", [](DiskSurface& s) { s.trackWidth = 32.2e-6; },
            "track_width must be a whole multiple of the map's cell of 0.25 um, for example 32.25 um");
        row(
            "no cell", [](DiskSurface& s) { s.cell = 0.0; }, "cell must be above 0");
        row(
            "a map beyond all memory", [](DiskSurface& s) { s.track = 0.2; },
            "cell must be larger, or the track shorter or narrower: the map would have 102 million of them; at most 64 "
            "million "
            "fit");

        row(
            "cut-off below two cells",
            [=](DiskSurface& s) {
                selfAffine(s);
                s.cutOff = 0.4e-6;
            },
            "cut_off must be at least 0.5 um, two cells of the map");
        row(
            "roll-off shorter than cut-off",
            [=](DiskSurface& s) {
                selfAffine(s);
                s.rollOff = 0.8e-6;
            },
            "roll_off must be at least 1 um, the cut-off wavelength");
        row(
            "roll-off longer than the track is wide",
            [=](DiskSurface& s) {
                selfAffine(s);
                s.rollOff = 40e-6;
            },
            "track_width must be at least 40 um, the roll-off wavelength");
        row(
            "a Hurst exponent above 1",
            [=](DiskSurface& s) {
                selfAffine(s);
                s.hurst = 1.2;
            },
            "hurst must be above 0 and at most 1");

        row(
            "no file", [](DiskSurface& s) { s = only(DiskSurfaceKind::File); },
            "file must name a profile or a map where the surface comes from a file");

        row(
            "no bumps", [](DiskSurface& s) { s = only(DiskSurfaceKind::Bumps); },
            "bump_heights must name at least one bump");
        row(
            "a bump without a place", [](DiskSurface& s) { s.bumpY = {}; },
            "bump_y must be as long as bump_heights: 1, not 0");
        row(
            "widths for other bumps",
            [](DiskSurface& s) {
                s.bumpWidths = {1e-6, 1e-6};
            },
            "bump_widths must be as long as bump_heights, or empty: 1, not 2");
        row(
            "a bump without length", [](DiskSurface& s) { s.bumpLengths = {0.0}; }, "bump_lengths must all be above 0");
        row(
            "a bump longer than the track",
            [](DiskSurface& s) {
                s.bumpLengths = {2e-3};
                s.bumpWidths = {1e-6};
            },
            "bump_lengths must be at most 1000 um, as long as the track, with which bumps repeat");
        row(
            "a round bump wider than the track", [](DiskSurface& s) { s.bumpLengths = {50e-6}; },
            "bump_lengths must be at most 32 um, as long as track_width, with which bumps repeat");
        row(
            "bumps on a track of no length",
            [](DiskSurface& s) {
                s.rms = 0.0;
                s.track = 0.0;
            },
            "track must be above 0");
    }
    void eachFaultIsOneSentence()
    {
        QFETCH(std::function<void(DiskSurface&)>, change);
        QFETCH(QByteArray, sentence);
        DiskSurface s = combined();
        change(s);
        QCOMPARE(text(diskSurfaceProblems(s)), sentence.toStdString());
    }

    void allFaultsAreToldAtOnce()
    {
        DiskSurface s = combined();
        s.waveLengths = {1e-6};
        s.rms = -1.0;
        s.bumpX = {};
        QCOMPARE(diskSurfaceProblems(s).size(), std::size_t(3));
    }

    /// The rms of the rises over their step: of 1, 1, 2 along x sqrt(6/3), of 3 across 3; a profile has no slope
    /// across.
    void theSlopeOfAMeasuredSurface()
    {
        const HeightMap profile{4, 1, 2.0, 0.0, {0.0, 1.0, 2.0, 4.0}, false, false};
        QVERIFY(std::abs(rmsSlope(profile) - std::sqrt(2.0) / 2.0) < 1e-15);
        const HeightMap map{4, 2, 2.0, 2.0, {0.0, 1.0, 2.0, 4.0, 3.0, 4.0, 5.0, 7.0}, false, false};
        QVERIFY(std::abs(rmsSlope(map) - 1.5) < 1e-15);
    }

    /// Heights of +-h at steps dx have a slope of 2 h/dx. Swapped units of um and nm give 1e6 times the slope.
    void aSteepSurfaceIsRefused_data()
    {
        QTest::addColumn<double>("slope");
        QTest::addColumn<int>("problems");
        QTest::addColumn<int>("warnings");
        QTest::newRow("of a disk") << 0.0005 << 0 << 0;
        QTest::newRow("rough") << 0.099 << 0 << 0;
        QTest::newRow("steep") << 0.101 << 0 << 1;
        QTest::newRow("very steep") << 0.99 << 0 << 1;
        QTest::newRow("too steep") << 1.01 << 1 << 1;
        QTest::newRow("swapped units") << 500.0 << 1 << 1;
    }
    void aSteepSurfaceIsRefused()
    {
        QFETCH(double, slope);
        QFETCH(int, problems);
        QFETCH(int, warnings);
        const double h = 0.5e-6 * slope;
        HeightMap map{4, 1, 1e-6, 0.0, {h, -h, h, -h}, false, false};
        if (slope > 10.0) map.heights = {1e-6 * h, -1e-6 * h, 1e-6 * h, -1e-6 * h}, map.dx *= 1e-6;
        QCOMPARE(heightMapProblems(map).size(), static_cast<std::size_t>(problems));
        QCOMPARE(heightMapWarnings(map).size(), static_cast<std::size_t>(warnings));
    }

    /// Heights of +-h have an rms of h.
    void measuredSurfacesInAnotherUnitAreWarnedOf()
    {
        const auto warnings = [](double h, double dx, double dy, int ny) {
            HeightMap map{4, ny, dx, dy, {}, false, false};
            for (int k = 0; k < 4 * ny; ++k) map.heights.push_back(k % 2 == 0 ? h : -h);
            return heightMapWarnings(map).size();
        };
        QCOMPARE(warnings(9.9e-6, 1e-3, 1e-6, 2), std::size_t{0});
        QCOMPARE(warnings(10.1e-6, 1e-3, 1e-6, 2), std::size_t{1});
        QCOMPARE(warnings(1e-9, 0.9e-3, 1e-6, 2), std::size_t{0});
        QCOMPARE(warnings(1e-9, 1.1e-3, 1e-6, 2), std::size_t{1});
        QCOMPARE(warnings(1e-9, 1e-6, 1.1e-3, 2), std::size_t{1});
        QCOMPARE(warnings(1e-9, 1e-6, 1.0, 1), std::size_t{0}); // a profile has no dy
        QCOMPARE(warnings(1.0, 1.0, 1.0, 2), std::size_t{3});
    }
};

TOUCHDOWN_TEST(TestDiskSurfaceCheck)

} // namespace test_disk_surface_check

#include "test_disk_surface_check.moc"
