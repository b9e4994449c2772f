// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/surface_statistics.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_statistics {

using std::numbers::pi;
const UniformGrid strip{256, 8, 0.5e-6, 1e-6, 0.0, 0.0};

template <typename Height>
std::vector<double> sampled(const UniformGrid& grid, const Height& height)
{
    std::vector<double> heights;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) heights.push_back(height(grid.x(i), grid.y(j)));
    return heights;
}

double integral(const ProfilePsd& psd)
{
    double sum = 0.0;
    for (const double density : psd.density) sum += density * psd.waveNumber.front();
    return sum;
}

class TestSurfaceStatistics : public QObject {
    Q_OBJECT

private slots:
    // Of 3 + 2 sin: mean 3, RMS sqrt 2, kurtosis <sin^4>/<sin^2>^2 = 3/2.
    void aSineHasItsOwn()
    {
        const double k = 2.0 * pi * 4 / 128e-6; // four waves in the strip
        const auto heights = sampled(strip, [&](double x, double) { return 3e-9 + 2e-9 * std::sin(k * x); });
        const SurfaceStatistics s = surfaceStatistics(strip, heights, true);
        QVERIFY(std::abs(s.mean - 3e-9) < 1e-22);
        QVERIFY(std::abs(s.rms - std::sqrt(2.0) * 1e-9) < 1e-22);
        QVERIFY(std::abs(s.skewness) < 1e-12);
        QVERIFY(std::abs(s.kurtosis - 1.5) < 1e-12);
        // Differences over d of a sine: 2 sin(k d/2)/d of its amplitude.
        QVERIFY(std::abs(s.slopeX - std::sqrt(2.0) * 1e-9 * 2.0 * std::sin(0.25e-6 * k) / 0.5e-6) < 1e-16);
        QCOMPARE(s.slopeY, 0.0);
        QCOMPARE(s.maximum, *std::ranges::max_element(heights));
        QCOMPARE(s.minimum, *std::ranges::min_element(heights));
        // cos(k L) = 1/e; between points it is taken as a straight line.
        QVERIFY(std::abs(s.correlationLength - std::acos(1.0 / std::numbers::e) / k) < 0.01 * 0.5e-6);
        QCOMPARE(s.psd.density.size(), std::size_t(128));
        QVERIFY(std::abs(s.psd.waveNumber[3] / k - 1.0) < 1e-12);
        QVERIFY(std::abs(s.psd.density[3] * s.psd.waveNumber[0] / (s.rms * s.rms) - 1.0) < 1e-12);
    }

    void theSlopeAcrossIsFoundToo()
    {
        const auto heights = sampled(strip, [](double, double y) { return 1e-9 * std::sin(2.0 * pi * y / 8e-6); });
        const SurfaceStatistics s = surfaceStatistics(strip, heights, true);
        QVERIFY(std::abs(s.slopeY - 1e-9 / std::sqrt(2.0) * 2.0 * std::sin(pi / 8.0) / 1e-6) < 1e-16);
        QCOMPARE(s.slopeX, 0.0);
        QVERIFY(integral(s.psd) < 1e-12 * s.rms * s.rms); // nothing along the track
        QCOMPARE(s.correlationLength, 0.0);
    }

    // One point in four is 3, the others -1: mean 0, variance 3, third moment (27 - 3)/4 = 6, fourth (81 + 3)/4 = 21.
    void skewnessAndKurtosis()
    {
        std::vector<double> heights(strip.cells());
        for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = i % 4 == 0 ? 3.0 : -1.0;
        const SurfaceStatistics s = surfaceStatistics(strip, heights, true);
        QVERIFY(std::abs(s.skewness - 6.0 / std::pow(3.0, 1.5)) < 1e-12);
        QVERIFY(std::abs(s.kurtosis - 21.0 / 9.0) < 1e-12);
    }

    void theDensityAddsUpToTheVariance_data()
    {
        QTest::addColumn<int>("nx");
        QTest::newRow("even") << 128;
        QTest::newRow("odd") << 129;
    }
    void theDensityAddsUpToTheVariance()
    {
        QFETCH(int, nx);
        UniformGrid grid = strip;
        grid.nx = nx;
        // Each row with the mean 0, so that nothing is in the wave number 0.
        auto heights = sampled(grid, [](double x, double y) { return std::cos(1e12 * x * x + 3e6 * y); });
        for (int j = 0; j < grid.ny; ++j) {
            const auto row = std::span(heights).subspan(static_cast<std::size_t>(j * nx), static_cast<std::size_t>(nx));
            double sum = 0.0;
            for (const double h : row) sum += h;
            for (double& h : row) h -= sum / nx;
        }
        const SurfaceStatistics s = surfaceStatistics(grid, heights, true);
        QVERIFY(std::abs(integral(s.psd) / (s.rms * s.rms) - 1.0) < 1e-12);
    }

    // 4.5 waves of a sine, taken as periodic: at step k stands (9/(k^2 - 4.5^2)/pi)^2 of the variance, from step 10 on
    // 0.4 % in all; behind a Hann window next to nothing, and the whole stays.
    void whatDoesNotRepeatIsSeenThroughAWindow()
    {
        const double step = 2.0 * pi / 128e-6;
        const auto heights = sampled(strip, [&](double x, double) { return std::sin(4.5 * step * x); });
        const auto away = [&](const SurfaceStatistics& s) {
            double sum = 0.0;
            for (std::size_t k = 9; k < s.psd.density.size(); ++k) sum += s.psd.density[k] * step;
            return sum / integral(s.psd);
        };
        const SurfaceStatistics leaking = surfaceStatistics(strip, heights, true);
        const SurfaceStatistics windowed = surfaceStatistics(strip, heights, false);
        QVERIFY(away(leaking) > 0.003);
        QVERIFY(away(leaking) < 0.005);
        QVERIFY(away(windowed) < 1e-4);
        QVERIFY(std::abs(integral(windowed.psd) / (windowed.rms * windowed.rms) - 1.0) < 0.05);
        const double expected = std::acos(1.0 / std::numbers::e) / (4.5 * step);
        QVERIFY(std::abs(windowed.correlationLength / expected - 1.0) < 0.05);
    }

    void aFlatSurfaceHasNothingToTell()
    {
        const SurfaceStatistics s = surfaceStatistics(strip, std::vector<double>(strip.cells(), 2e-9), true);
        QVERIFY(std::abs(s.mean - 2e-9) < 1e-22);
        QCOMPARE(s.rms, 0.0);
        QCOMPARE(s.skewness, 0.0);
        QVERIFY(s.psd.density.empty());
        const SurfaceStatistics flat = surfaceStatistics(DiskSurface{}, DiskTopography());
        QCOMPARE(flat.rms, 0.0);
    }

    void aProfileIsEnough()
    {
        const UniformGrid line{64, 1, 1e-6, 1e-6, 0.0, 0.0};
        const auto heights = sampled(line, [](double x, double) { return std::sin(2.0 * pi * x / 32e-6); });
        for (const bool periodic : {true, false}) {
            const SurfaceStatistics s = surfaceStatistics(line, heights, periodic);
            QCOMPARE(s.slopeY, 0.0);
            QVERIFY(std::abs(s.rms - std::sqrt(0.5)) < 1e-12);
        }
    }

    void aSurfaceIsReadRowByRow()
    {
        DiskSurface surface;
        surface.kind = DiskSurfaceKind::Rough;
        surface.track = 50e-6;
        const DiskTopography topography(surface);
        const UniformGrid grid = topography.period();
        std::vector<double> heights(grid.cells());
        topography.heights(grid, 0.0, 0.0, heights);
        const SurfaceStatistics rows = surfaceStatistics(surface, topography),
                                all = surfaceStatistics(grid, heights, true);
        QVERIFY(std::abs(rows.rms / all.rms - 1.0) < 1e-12);
        QVERIFY(std::abs(rows.slopeY / all.slopeY - 1.0) < 1e-9);
        QVERIFY(std::abs(rows.correlationLength / all.correlationLength - 1.0) < 1e-9);
        QCOMPARE(rows.psd.density.size(), all.psd.density.size());
    }

    /// The heights 0 to n-1 nm have an rms of sqrt((n^2-1)/12) nm. The surface goes on with their mirror image, whose
    /// statistics are others; a closed file is its own period.
    void aMeasuredSurfaceHasTheStatisticsOfItsFile()
    {
        DiskSurface surface;
        surface.kind = DiskSurfaceKind::File;
        surface.file = "map.txt";
        for (const int rows : {1, 3})
            for (const bool closed : {false, true}) {
                HeightMap map{10, rows, 1e-6, 2e-6, {}, closed, closed && rows > 1};
                for (int k = 0; k < 10 * rows; ++k) map.heights.push_back(1e-9 * (k % 10));
                const SurfaceStatistics s = surfaceStatistics(surface, DiskTopography(surface, map));
                QVERIFY(std::abs(s.rms - 1e-9 * std::sqrt(99.0 / 12.0)) < 1e-18);
                QVERIFY(std::abs(s.maximum - s.minimum - 9e-9) < 1e-18);
                // Nine rises of 1 nm in 1 um, and a fall of 9 nm where the file closes.
                const double slope = closed ? 1e-3 * std::sqrt((9.0 + 81.0) / 10.0) : 1e-3;
                QVERIFY(std::abs(s.slopeX / slope - 1.0) < 1e-9);
            }
        // Together with waves it is no more the surface of the file.
        surface.kind = DiskSurfaceKind::Combined;
        surface.waveAmplitudes = {1e-9};
        surface.waveLengths = {5e-6};
        HeightMap map{10, 1, 1e-6, 0.0, std::vector<double>(10), false, false};
        map.heights[3] = 1e-9;
        const DiskTopography both(surface, map);
        QCOMPARE(both.measured(), both.period());
    }

    /// Over two tracks a wave of 2/n tracks, n odd, repeats together with the roughness, and the sums of their products
    /// vanish, as the map has even multiples only. A wave of ten tracks needs no such sum: its RMS is a/sqrt(2).
    void wavesCountWithTheirWholeLength()
    {
        DiskSurface rough;
        rough.kind = DiskSurfaceKind::Rough;
        rough.track = 40e-6;
        rough.trackWidth = 16e-6;
        rough.rms = 0.3e-9;
        const SurfaceStatistics map = surfaceStatistics(rough, DiskTopography(rough));
        for (const double length : {80e-6, 80e-6 / 3, 80e-6 / 7, 400e-6})
            for (const double phase : {0.0, 1.0, 2.5}) {
                DiskSurface surface = rough;
                surface.kind = DiskSurfaceKind::Combined;
                surface.waveAmplitudes = {2e-9};
                surface.waveLengths = {length};
                surface.wavePhases = {phase};
                const DiskTopography topography(surface);
                const SurfaceStatistics s = surfaceStatistics(surface, topography);
                const double k = 2.0 * pi / length;
                QVERIFY(std::abs(s.rms / std::sqrt(0.3e-9 * 0.3e-9 + 2e-18) - 1.0) < 1e-12);
                QVERIFY(std::abs(s.slopeX / std::hypot(map.slopeX, std::sqrt(2.0) * 1e-9 * k) - 1.0) < 1e-12);
                QVERIFY(std::abs(s.slopeY / map.slopeY - 1.0) < 1e-12);
                QVERIFY(s.boundsAlone && std::isnan(s.skewness) && std::isnan(s.kurtosis));
                QVERIFY(std::abs(s.maximum - map.maximum - 2e-9) < 1e-20);
                QVERIFY(std::abs(s.minimum - map.minimum + 2e-9) < 1e-20);
                if (length > 100e-6) continue;
                UniformGrid two = topography.period();
                two.nx *= 2;
                std::vector<double> heights(two.cells());
                topography.heights(two, 0.0, 0.0, heights);
                const SurfaceStatistics read = surfaceStatistics(two, heights, true);
                QVERIFY(std::abs(s.rms / read.rms - 1.0) < 1e-9);
                QVERIFY(read.maximum <= s.maximum && read.minimum >= s.minimum);
            }
    }

    /// a sin(u) + b sin(u + c) has the amplitude |a + b exp(ic)|; sin(-u + c) = sin(u + pi - c). Waves alone, too.
    void equalWavesAddWithTheirPhases()
    {
        DiskSurface surface;
        surface.kind = DiskSurfaceKind::Waves;
        const auto rms = [&](std::vector<double> angles, std::vector<double> phases) {
            surface.waveAmplitudes = {3e-9, 4e-9};
            surface.waveLengths = {7e-3, 7e-3};
            surface.waveAngles = std::move(angles);
            surface.wavePhases = std::move(phases);
            return surfaceStatistics(surface, DiskTopography(surface)).rms / (1e-9 * std::numbers::sqrt2 / 2.0);
        };
        QVERIFY(std::abs(rms({}, {0.3, 0.3}) - 7.0) < 1e-9);
        QVERIFY(std::abs(rms({}, {0.3, 0.3 + pi}) - 1.0) < 1e-9);
        QVERIFY(std::abs(rms({}, {0.3, 0.3 + 0.5 * pi}) - 5.0) < 1e-9);
        QVERIFY(std::abs(rms({0.0, pi}, {0.3, pi - 0.3}) - 7.0) < 1e-6);
        QVERIFY(std::abs(rms({0.0, 0.1}, {0.3, 0.3}) - 5.0) < 1e-9); // others are independent
    }

    /// Waves that fit in the track are read with the map: their RMS knows how both lie to one another.
    void wavesThatRepeatAreRead()
    {
        DiskSurface surface;
        surface.kind = DiskSurfaceKind::Combined;
        surface.track = 40e-6;
        surface.trackWidth = 16e-6;
        surface.waveAmplitudes = {1e-9, 0.5e-9};
        surface.waveLengths = {40e-6, 10e-6};
        const DiskTopography topography(surface);
        const UniformGrid grid = topography.period();
        std::vector<double> heights(grid.cells());
        topography.heights(grid, 0.0, 0.0, heights);
        const SurfaceStatistics s = surfaceStatistics(surface, topography),
                                read = surfaceStatistics(grid, heights, true);
        QVERIFY(std::abs(s.rms / read.rms - 1.0) < 1e-12);
        QCOMPARE(s.maximum, read.maximum);
        QVERIFY(!s.boundsAlone && std::abs(s.kurtosis - read.kurtosis) < 1e-9);
    }

    void binsKeepTheIntegral()
    {
        ProfilePsd psd;
        for (int k = 1; k <= 2000; ++k) {
            psd.waveNumber.push_back(1e3 * k);
            psd.density.push_back(1.0 / k);
            psd.modes.push_back(1);
        }
        const ProfilePsd bins = averaged(psd, 10);
        QVERIFY(bins.density.size() <= 34); // 3.3 decades
        double before = 0.0, after = 0.0;
        int modes = 0;
        for (const double density : psd.density) before += density;
        for (std::size_t k = 0; k < bins.density.size(); ++k) {
            after += bins.density[k] * bins.modes[k];
            modes += bins.modes[k];
            if (k > 0) QVERIFY(bins.waveNumber[k] > bins.waveNumber[k - 1]);
        }
        QCOMPARE(modes, 2000);
        QVERIFY(std::abs(after / before - 1.0) < 1e-12);
        QVERIFY(averaged({}, 10).density.empty());
    }
};

TOUCHDOWN_TEST(TestSurfaceStatistics)

} // namespace test_surface_statistics

#include "test_surface_statistics.moc"
