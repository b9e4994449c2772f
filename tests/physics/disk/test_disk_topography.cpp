// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/disk_topography.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <thread>

#include "core/physics/disk/roughness.h"
#include "tests/support/allocation_count.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_disk_topography {

using std::numbers::pi;

DiskSurface rough(RoughnessSpectrum spectrum = RoughnessSpectrum::Gaussian)
{
    DiskSurface s;
    s.kind = DiskSurfaceKind::Rough;
    s.spectrum = spectrum;
    s.track = 100e-6;
    return s;
}

DiskSurface combined()
{
    DiskSurface s = rough();
    s.kind = DiskSurfaceKind::Combined;
    s.waveAmplitudes = {1e-9};
    s.waveLengths = {30e-6};
    s.bumpHeights = {5e-9, -2e-9};
    s.bumpLengths = {8e-6, 6e-6};
    s.bumpX = {10e-6, 40e-6};
    s.bumpY = {16e-6, 1e-6};
    s.bumpShape = BumpShape::Cosine;
    s.file = "profile.txt";
    return s;
}

DiskSurface fromFile()
{
    DiskSurface s;
    s.kind = DiskSurfaceKind::File;
    s.file = "map.txt";
    return s;
}

/// A ramp: what does not close must be mirrored.
HeightMap ramp(int nx)
{
    HeightMap map{nx, 1, 1e-6, 0.0, {}, false, false};
    for (int i = 0; i < nx; ++i) map.heights.push_back(1e-9 * i);
    return map;
}

std::vector<double> heightsOf(const DiskTopography& t, const UniformGrid& grid, double shiftX = 0.0,
                              double shiftY = 0.0)
{
    std::vector<double> out(grid.cells());
    t.heights(grid, shiftX, shiftY, out);
    return out;
}

class TestDiskTopography : public QObject {
    Q_OBJECT

private slots:
    void boundsHeightsInARectangle_data();
    void boundsHeightsInARectangle();
    void boundsItsCurvature_data();
    void boundsItsCurvature();
    void aFlatDiskIsFlat()
    {
        DiskSurface withoutTrack;
        withoutTrack.track = withoutTrack.cell = std::numeric_limits<double>::quiet_NaN();
        for (const DiskTopography& disk :
             {DiskTopography(), DiskTopography(DiskSurface{}), DiskTopography(withoutTrack)}) {
            QVERIFY(disk.flat());
            QCOMPARE(disk.period(), DiskTopography().period());
            QVERIFY(disk.repeats());
            QCOMPARE(disk.height(1e-3, 2e-3), 0.0);
            QCOMPARE(disk.highest(), 0.0);
            QCOMPARE(disk.lowest(), 0.0);
            QCOMPARE(heightsOf(disk, {3, 2, 1e-6, 1e-6, 0.0, 0.0}), std::vector<double>(6, 0.0));
        }
    }

    void thePointsAreTheGeneratedOnes_data()
    {
        QTest::addColumn<int>("spectrum");
        QTest::newRow("gaussian") << 0;
        QTest::newRow("exponential") << 1;
        QTest::newRow("self-affine") << 2;
    }
    void thePointsAreTheGeneratedOnes()
    {
        QFETCH(int, spectrum);
        const DiskSurface s = rough(static_cast<RoughnessSpectrum>(spectrum));
        const DiskTopography disk(s);
        const auto generated = generateRoughness(s);
        QCOMPARE(disk.period(), (UniformGrid{400, 128, 0.25e-6, 0.25e-6, -0.125e-6, -0.125e-6}));
        const auto read = heightsOf(disk, disk.period());
        for (std::size_t k = 0; k < read.size(); ++k) QVERIFY(std::abs(read[k] - generated[k]) < 1e-12 * s.rms);
    }

    void movedByWholeCellsItReturnsTheSameBits_data()
    {
        QTest::addColumn<int>("cellsX");
        QTest::addColumn<int>("cellsY");
        QTest::newRow("one cell") << 1 << 0;
        QTest::newRow("back and across") << -37 << 5;
        QTest::newRow("a period") << 400 << 128;
        QTest::newRow("a million periods and three cells") << 400000003 << -128000002;
    }
    void movedByWholeCellsItReturnsTheSameBits()
    {
        QFETCH(int, cellsX);
        QFETCH(int, cellsY);
        for (int spectrum = 0; spectrum < 3; ++spectrum) {
            const DiskTopography disk(rough(static_cast<RoughnessSpectrum>(spectrum)));
            const UniformGrid grid = disk.period();
            const auto still = heightsOf(disk, grid);
            const auto moved = heightsOf(disk, grid, cellsX * 0.25e-6, cellsY * 0.25e-6);
            const auto wrapped = [](int i, int n) { return (i % n + n) % n; };
            for (int j = 0; j < grid.ny; ++j)
                for (int i = 0; i < grid.nx; ++i)
                    QCOMPARE(moved[static_cast<std::size_t>(j * grid.nx + i)],
                             still[static_cast<std::size_t>(wrapped(j - cellsY, grid.ny) * grid.nx +
                                                            wrapped(i - cellsX, grid.nx))]);
        }
    }

    // The slopes over h, a 25th of a cell, before and behind the seam differ by h times the curvature, as anywhere; a
    // kink or a step would stand out by 25 and more.
    void thereIsNoSeam()
    {
        for (int spectrum = 0; spectrum < 3; ++spectrum) {
            const DiskTopography disk(rough(static_cast<RoughnessSpectrum>(spectrum)));
            const double h = 0.01e-6;
            // Slopes before and behind each of 200 places 1/2 um apart, beginning at the seam.
            double seam = 0.0, elsewhere = 0.0;
            for (int k = 0; k < 200; ++k)
                for (int j = 0; j < 32; ++j) {
                    const double x = 0.5e-6 * k, y = 1.1e-6 * j;
                    const double kink =
                        std::abs(disk.height(x + h, y) - 2.0 * disk.height(x, y) + disk.height(x - h, y)) / h;
                    (k == 0 ? seam : elsewhere) = std::max(k == 0 ? seam : elsewhere, kink);
                }
            QVERIFY2(seam <= elsewhere, qPrintable(QString("%1 %2").arg(seam).arg(elsewhere)));
        }
    }

    void aGridSeesWhatASinglePointSees()
    {
        const DiskTopography disk(combined(), ramp(30));
        const UniformGrid grid{90, 40, 0.33e-6, 0.41e-6, -7e-6, 3e-6};
        const auto heights = heightsOf(disk, grid, 55.5e-6, -9.9e-6);
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < grid.nx; ++i) {
                const double expected = disk.height(grid.x(i) - 55.5e-6, grid.y(j) + 9.9e-6);
                // Positions are rounded to 1e-9 of a cell; slopes are below 1 nm in a cell of 0.25 um.
                QVERIFY(std::abs(heights[static_cast<std::size_t>(j * grid.nx + i)] - expected) < 2e-18);
            }
    }

    void theMeanOfSmallCellsIsTheHeight()
    {
        const DiskTopography disk(combined(), ramp(30));
        CellGrid grid;
        for (int i = 0; i <= 50; ++i) grid.x.push_back(0.61e-6 * i);
        for (int j = 0; j <= 30; ++j) grid.y.push_back(0.53e-6 * j);
        // Cells of 20 nm side around each line's place.
        CellGrid small{{}, {}};
        std::vector<double> means(1);
        for (const double x : grid.x)
            for (const double y : grid.y) {
                small.x = {x - 10e-9, x + 10e-9};
                small.y = {y - 10e-9, y + 10e-9};
                disk.cellMeans(small, 3e-6, 1e-6, means);
                // (20 nm)^2/24 of the curvatures along and across [1/m]: of the ramp where it turns 2e-3/0.6 um = 3500;
                // of a bump 2.5 nm (pi/4 um)^2 = 1500 each way; of the roughness, four deviations of sqrt(12) rms/lc^2,
                // 700.
                QVERIFY(std::abs(means[0] - disk.height(x - 3e-6, y - 1e-6)) < 1.7e-17 * 8000);
            }
    }

    void wideCellsSeeAlmostNothing()
    {
        // Cells of the whole period: the mean of the map, 0.
        DiskSurface s = rough();
        const DiskTopography disk(s);
        CellGrid grid{{0.0, 100e-6, 200e-6}, {0.0, 32e-6}};
        std::vector<double> means(2);
        disk.cellMeans(grid, 12.3e-6, 4.5e-6, means);
        for (const double mean : means) QVERIFY(std::abs(mean) < 1e-12 * s.rms);
    }

    void theBoundsHold()
    {
        const DiskTopography disk(combined(), ramp(30));
        const UniformGrid grid{500, 320, 0.21e-6, 0.1e-6, 0.0, 0.0};
        const auto heights = heightsOf(disk, grid);
        QVERIFY(*std::ranges::max_element(heights) <= disk.highest());
        QVERIFY(*std::ranges::min_element(heights) >= disk.lowest());
        // Of the default roughness alone they are close: within 5 % of the extremes on the points.
        const DiskTopography map(rough());
        const auto points = heightsOf(map, map.period());
        QVERIFY(map.highest() < 1.05 * *std::ranges::max_element(points));
        QVERIFY(map.lowest() > 1.05 * *std::ranges::min_element(points));
    }

    // 0, 1 ... 9 nm and back without the end points: a mean of (45 + 36)/18 = 4.5 nm, which is taken off.
    void aProfileThatDoesNotCloseIsFollowedByItsMirrorImage()
    {
        const DiskTopography disk(fromFile(), ramp(10));
        QCOMPARE(disk.period().nx, 18);
        QCOMPARE(disk.period().ny, 1);
        for (int i = -20; i < 40; ++i) {
            const int k = (i % 18 + 18) % 18;
            const double expected = 1e-9 * (k < 10 ? k : 18 - k) - 4.5e-9;
            for (const double y : {0.0, 3.3e-6, -1e-3}) QVERIFY(std::abs(disk.height(i * 1e-6, y) - expected) < 1e-20);
        }
    }

    void aMapIsMirroredAcrossToo()
    {
        HeightMap map{4, 3, 1e-6, 2e-6, {0, 1, 2, 3, 10, 11, 12, 13, 20, 21, 22, 23}, false, false};
        for (double& h : map.heights) h *= 1e-9;
        const DiskTopography disk(fromFile(), map);
        QCOMPARE(disk.period(), (UniformGrid{6, 4, 1e-6, 2e-6, -0.5e-6, -1e-6}));
        const double mean = (0 + 1 + 2 + 3 + 2 + 1) / 6.0 + (0 + 10 + 20 + 10) / 4.0;
        QVERIFY(std::abs(disk.height(4e-6, 2e-6) - (12 - mean) * 1e-9) < 1e-20);
        QVERIFY(std::abs(disk.height(-1e-6, 6e-6) - (11 - mean) * 1e-9) < 1e-20);
    }

    void aClosedProfileRepeatsAsItIs()
    {
        HeightMap map{8, 1, 1e-6, 0.0, {}, true, false};
        for (int i = 0; i < 8; ++i) map.heights.push_back(1e-9 * std::sin(2.0 * pi * i / 8));
        const DiskTopography disk(fromFile(), map);
        QCOMPARE(disk.period().nx, 8);
        for (int i = -3; i < 20; ++i)
            QVERIFY(std::abs(disk.height(i * 1e-6, 0.0) - 1e-9 * std::sin(2.0 * pi * i / 8)) < 1e-22);
    }

    void onlyWhatRepeatsSaysSo()
    {
        QVERIFY(DiskTopography(rough()).repeats());
        QVERIFY(!DiskTopography(combined(), ramp(30)).repeats());
        DiskSurface waves = combined();
        waves.kind = DiskSurfaceKind::Waves;
        QVERIFY(!DiskTopography(waves).repeats());
        DiskSurface bumps = combined();
        bumps.kind = DiskSurfaceKind::Bumps;
        QVERIFY(DiskTopography(bumps).repeats());
        QVERIFY(DiskTopography(fromFile(), ramp(9)).repeats());
    }

    /// Slopes are what differences of the heights say, and agree with the spline's value at the same place. Waves, maps
    /// and bumps of each shape; an ellipsoid has its slope inside its base.
    void aPointHasTheSlopesOfItsHeights()
    {
        for (const BumpShape shape : {BumpShape::Cosine, BumpShape::Gaussian, BumpShape::Ellipsoid}) {
            DiskSurface surface = combined();
            surface.bumpShape = shape;
            surface.waveAngles = {0.4};
            const DiskTopography disk(surface, ramp(30));
            constexpr double step = 1e-9; // the third derivative is some 1e9 /m^2 at most: 1e-9 of the slope
            for (const auto& [x, y] : {std::pair(11.3e-6, 15.1e-6), std::pair(40.2e-6, 1.1e-6),
                                       std::pair(-3.17e-6, 40.9e-6), std::pair(0.0261, -7.3e-6)}) {
                const DiskPoint at = disk.point(x, y);
                QVERIFY(std::abs(at.height - disk.height(x, y)) < 1e-16);
                const double alongX = disk.point(x + step, y).height - disk.point(x - step, y).height;
                const double alongY = disk.point(x, y + step).height - disk.point(x, y - step).height;
                QVERIFY2(std::abs(0.5 * alongX / step - at.slopeX) < 2e-8, qPrintable(QString::number(at.slopeX)));
                QVERIFY2(std::abs(0.5 * alongY / step - at.slopeY) < 2e-8, qPrintable(QString::number(at.slopeY)));
                QVERIFY(std::abs(at.slopeX) > 1e-5);
            }
        }
    }

    void readingAllocatesNothing()
    {
        const DiskTopography disk(combined(), ramp(30));
        const UniformGrid patch{300, 64, 0.25e-6, 0.25e-6, 0.0, 0.0};
        CellGrid film;
        for (int i = 0; i <= 150; ++i) film.x.push_back(5e-6 * i);
        for (int j = 0; j <= 20; ++j) film.y.push_back(4e-6 * j);
        std::vector<double> heights(patch.cells()), means(film.cells());
        std::vector<double> work, again(film.cells());
        disk.cellMeans(film, 1.1e-6, 0.0, again, work);
        const long long before = test::allocations;
        disk.heights(patch, 1.3e-6, 0.2e-6, heights);
        disk.cellMeans(film, 1.3e-6, 0.2e-6, again, work);
        QCOMPARE(test::allocations.load(), before);
        disk.cellMeans(film, 1.3e-6, 0.2e-6, means);
        QVERIFY(means == again);
    }

    void threadsMayReadAtOnce()
    {
        const DiskTopography disk(combined(), ramp(30));
        const UniformGrid grid{200, 100, 0.3e-6, 0.3e-6, 0.0, 0.0};
        const auto alone = heightsOf(disk, grid, 7e-6);
        std::vector<std::vector<double>> together(4);
        {
            std::vector<std::jthread> threads;
            for (auto& out : together) threads.emplace_back([&] { out = heightsOf(disk, grid, 7e-6); });
        }
        for (const auto& out : together) QVERIFY(out == alone);
    }
};

void TestDiskTopography::boundsHeightsInARectangle_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 9; ++seed) QTest::addRow("seed %d", seed) << seed;
}

/// Waves, a generated map and bumps, in drawn rectangles of all sizes, far from the origin, too: no height is above the
/// bound, and that of a small rectangle is close to its highest point.
void TestDiskTopography::boundsHeightsInARectangle()
{
    QFETCH(int, seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    DiskSurface s;
    s.kind = seed % 3 == 0 ? DiskSurfaceKind::Waves : seed % 3 == 1 ? DiskSurfaceKind::Rough : DiskSurfaceKind::Bumps;
    for (int k = 0; k < 3; ++k) {
        s.waveAmplitudes.push_back(draw(-2e-9, 2e-9));
        s.waveLengths.push_back(draw(5e-6, 200e-6));
        s.waveAngles.push_back(draw(-2.0, 2.0));
        s.wavePhases.push_back(draw(-4.0, 4.0));
        s.bumpHeights.push_back(draw(-5e-9, 5e-9));
        s.bumpLengths.push_back(draw(5e-6, 60e-6));
        s.bumpX.push_back(draw(0.0, 200e-6));
        s.bumpY.push_back(draw(0.0, 60e-6));
    }
    s.bumpShape = BumpShape::Gaussian;
    s.rms = 1e-9;
    s.correlationLength = 5e-6;
    s.cell = 1e-6;
    s.track = 203e-6; // no multiple of the blocks of the bound
    s.trackWidth = 61e-6;
    s.seed = seed;
    const DiskTopography disk(s);
    const double range = disk.highest() - disk.lowest();
    for (int box = 0; box < 200; ++box) {
        const double x0 = draw(-2e-3, 2e-3), y0 = draw(-1e-3, 1e-3),
                     side = std::exp(draw(std::log(0.1e-6), std::log(200e-6))), x1 = x0 + side,
                     y1 = y0 + draw(0.1, 1.0) * side;
        double highest = -1.0;
        for (int j = 0; j <= 20; ++j)
            for (int i = 0; i <= 20; ++i)
                highest = std::max(highest, disk.height(x0 + (x1 - x0) * i / 20, y0 + (y1 - y0) * j / 20));
        const double bound = disk.upperBound(x0, x1, y0, y1);
        QVERIFY2(bound >= highest - 1e-18, qPrintable(QString::number(bound - highest)));
        if (side < 0.2e-6 && s.kind != DiskSurfaceKind::Rough) QVERIFY(bound < highest + 0.1 * range);
    }
}

void TestDiskTopography::boundsItsCurvature_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 12; ++seed) QTest::addRow("seed %d", seed) << seed;
}

/// Second differences along drawn directions, at drawn places of waves, of a generated map and of bumps: none is above
/// the bound, and some come near it.
void TestDiskTopography::boundsItsCurvature()
{
    QFETCH(int, seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    DiskSurface s;
    s.kind = seed % 3 == 0 ? DiskSurfaceKind::Waves : seed % 3 == 1 ? DiskSurfaceKind::Rough : DiskSurfaceKind::Bumps;
    for (int k = 0; k < 2; ++k) {
        s.waveAmplitudes.push_back(draw(-2e-9, 2e-9));
        s.waveLengths.push_back(draw(20e-6, 60e-6));
        s.waveAngles.push_back(draw(-2.0, 2.0));
        s.wavePhases.push_back(draw(-4.0, 4.0));
        s.bumpHeights.push_back(draw(-5e-9, 5e-9));
        s.bumpLengths.push_back(draw(20e-6, 60e-6));
        s.bumpWidths.push_back(draw(20e-6, 60e-6));
        s.bumpX.push_back(draw(0.0, 300e-6));
        s.bumpY.push_back(draw(0.0, 200e-6));
    }
    s.bumpShape = static_cast<BumpShape>(seed / 3 % 3);
    s.rms = 1e-9;
    s.correlationLength = 8e-6;
    s.cell = 2e-6;
    s.track = 300e-6;
    s.trackWidth = 200e-6;
    s.seed = seed;
    const DiskTopography disk(s);
    // In rectangles of drawn sizes; no bound is infinite but at the base of an ellipsoid.
    constexpr double step = 0.1e-6;
    double most = 0.0, least = 1e300; // share of a bound that is reached [-], bound [1/m]
    for (int box = 0; box < 1000; ++box) {
        const double x0 = draw(0.0, s.track), y0 = draw(0.0, s.trackWidth), side = draw(0.5e-6, 20e-6);
        const CurvatureBound bound = disk.curvature(x0 - step, x0 + side + step, y0 - step, y0 + side + step);
        least = std::min(least, bound.x + bound.y);
        for (int place = 0; place < 30; ++place) {
            const double x = x0 + draw(0.0, side), y = y0 + draw(0.0, side), angle = draw(0.0, 3.2),
                         dx = step * std::cos(angle), dy = step * std::sin(angle);
            const double bent =
                disk.height(x - dx, y - dy) + disk.height(x + dx, y + dy) - 2.0 * disk.height(x, y); // [m]
            const double allowed = bound.x * dx * dx + bound.y * dy * dy;                            // [m]
            QVERIFY(std::abs(bent) <= 1.0001 * allowed + 1e-23);
            if (allowed > 0.0) most = std::max(most, std::abs(bent) / allowed);
        }
    }
    QVERIFY2(most > 0.4 && std::isfinite(least), qPrintable(QString::number(most)));
}

TOUCHDOWN_TEST(TestDiskTopography)

} // namespace test_disk_topography

#include "test_disk_topography.moc"
