// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/disk_on_cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QtTest>

#include "core/case/case.h"
#include "core/case/contact_kind.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/physics/film/film_grid.h"
#include "core/simulation/static_state/high_disk.h"
#include "core/simulation/static_state/steady.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_disk_on_cells {

class TestDiskOnCells : public QObject {
    Q_OBJECT

private slots:
    void countsTheCellsOfAWave_data();
    void countsTheCellsOfAWave();
    void cellsUnderASmallGapCountMost();
    void countsTheCellsOfABump();
    void knowsWhatMeansLoseOfARoughSurface_data();
    void knowsWhatMeansLoseOfARoughSurface();
    void aStepIsASixteenthOfAWave();
    void aStepFollowsNoWaveThatDoesNotMatter();
    void looksAtAllOfAMap();
    void aLongWaveCountsWithItsWholeLength();
    void saysBothNumbers();
    void saysWhereADiskReachesTheSlider();
    void aStaticStateSaysThatTheDiskIsHigher();
};

constexpr double length = 1e-3, width = 0.8e-3;
constexpr int cells = 80; // along each side: 12.5 um, 10 um

/// A level plane over a disk.
Case plane()
{
    Case c = test::smallSlider(cells + 1);
    c.slider.length = length;
    c.slider.width = width;
    c.surface = {};
    c.surface.baseRecess = 0.0;
    c.initial.nominalTrailingEdgeHeight = 10e-9;
    c.initial.pitch = 0.0;
    c.film.grid = GridKind::Uniform;
    c.contact = noContact;
    return c;
}

Case overWaves(double waveLength, double angle, double amplitude = 1e-9)
{
    Case c = plane();
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    c.diskSurface.waveAmplitudes = {amplitude};
    c.diskSurface.waveLengths = {waveLength};
    c.diskSurface.waveAngles = {angle};
    return c;
}

DiskOnCells seen(const Case& c)
{
    const Recess recess(c.surface, c.slider.length, c.slider.width);
    return diskOnCells(c, DiskTopography(c.diskSurface), recess, uniformGrid(length, width, cells, cells),
                       {c.initial.nominalTrailingEdgeHeight, c.initial.pitch, 0.0});
}

void TestDiskOnCells::countsTheCellsOfAWave_data()
{
    QTest::addColumn<double>("waveLength"); // [m]
    QTest::addColumn<double>("angle");      // [rad]
    QTest::addColumn<double>("count");
    QTest::newRow("along, 1.5 cells") << 1.5 * 12.5e-6 << 0.0 << 1.5;
    QTest::newRow("along, 4 cells") << 4 * 12.5e-6 << 0.0 << 4.0;
    QTest::newRow("across, 4 cells") << 4 * 10e-6 << 0.5 * std::numbers::pi << 4.0;
    // At 45 degrees the wave is sqrt 2 times as long along each axis.
    QTest::newRow("oblique") << 40e-6 << 0.25 * std::numbers::pi << 40.0 * std::numbers::sqrt2 / 12.5;
    QTest::newRow("along, 20 cells") << 20 * 12.5e-6 << 0.0 << 20.0;
}

void TestDiskOnCells::countsTheCellsOfAWave()
{
    QFETCH(double, waveLength);
    QFETCH(double, angle);
    QFETCH(double, count);
    const DiskOnCells found = seen(overWaves(waveLength, angle));
    QVERIFY(found.coarsest && found.coarsest->isWave);
    QVERIFY(std::abs(found.coarsest->cells - count) < 1e-6 * count);
    // The mean over a side b of a wave with the wave number k along it keeps sin(k b/2)/(k b/2).
    const auto sinc = [&](double side, double share) {
        const double u = std::numbers::pi * share * side / waveLength;
        return u > 0.0 ? std::sin(u) / u : 1.0;
    };
    const double kept = sinc(12.5e-6, std::cos(angle)) * sinc(10e-6, std::sin(angle));
    QVERIFY(std::abs(found.coarsest->kept - kept) < 1e-6);
    QCOMPARE(found.isResolved(), count >= 6.0);
    QCOMPARE(doubtsOnDisk(found, 0.0).empty(), count >= 6.0);
}

void TestDiskOnCells::cellsUnderASmallGapCountMost()
{
    // Half of the length has cells of 5 um, half of 20 um; pitched nose up by 1 mrad the gap is 10 nm at the trailing
    // edge and 1 um at the leading one, so that the trailing half has nearly all of the weight area/gap^2:
    // 1/h1 - 1/h over each half, 1/10 - 1/510 to 1/510 - 1/1010, that is 99 to 1.
    Case c = overWaves(60e-6, 0.0);
    c.initial.pitch = 1e-3;
    const Recess recess(c.surface, length, width);
    CellGrid grid;
    for (int i = 0; i <= 25; ++i) grid.x.push_back(i * 20e-6);
    for (int i = 1; i <= 100; ++i) grid.x.push_back(0.5e-3 + i * 5e-6);
    grid.y = {0.0, width};
    const auto count = [&](double pitch) {
        return diskOnCells(c, DiskTopography(c.diskSurface), recess, grid, {10e-9, pitch, 0.0}).coarsest->cells;
    };
    QVERIFY(std::abs(count(1e-3) - 60.0 / (0.99 * 5.0 + 0.01 * 20.0)) < 0.3);
    QVERIFY(std::abs(count(0.0) - 60.0 / 12.5) < 1e-9); // level: all count alike
}

void TestDiskOnCells::countsTheCellsOfABump()
{
    Case c = plane();
    c.diskSurface.kind = DiskSurfaceKind::Bumps;
    c.diskSurface.bumpHeights = {5e-9, 0.0}; // a bump without height does not count
    c.diskSurface.bumpLengths = {100e-6, 1e-6};
    c.diskSurface.bumpWidths = {40e-6, 1e-6};
    c.diskSurface.bumpX = {0.0, 0.0};
    c.diskSurface.bumpY = {0.0, 0.0};
    const DiskOnCells found = seen(c);
    QVERIFY(!found.coarsest->isWave);
    QVERIFY(std::abs(found.coarsest->cells - 4.0) < 1e-9); // of 10 um across
}

void TestDiskOnCells::knowsWhatMeansLoseOfARoughSurface_data()
{
    QTest::addColumn<double>("correlationLength"); // [m]
    for (const double each : {2e-6, 10e-6, 40e-6, 100e-6}) QTest::addRow("%g um", each * 1e6) << each;
}

void TestDiskOnCells::knowsWhatMeansLoseOfARoughSurface()
{
    QFETCH(double, correlationLength);
    Case c = plane();
    c.diskSurface.kind = DiskSurfaceKind::Rough;
    c.diskSurface.rms = 2e-9;
    c.diskSurface.correlationLength = correlationLength;
    c.diskSurface.cell = std::max(0.5e-6, correlationLength / 10.0);
    c.diskSurface.track = 1024 * c.diskSurface.cell;
    c.diskSurface.trackWidth = 256 * c.diskSurface.cell;
    const DiskOnCells found = seen(c);
    QVERIFY(std::abs(found.rms - 2e-9) < 0.15 * 2e-9);
    // Means over b of heights with the autocorrelation exp(-(x/l)^2) keep the share of the variance
    // 2/b^2 int (b - x) exp(-(x/l)^2) dx = sqrt(pi) l/b erf(b/l) - (l/b)^2 (1 - exp(-(b/l)^2)) along each axis.
    const auto share = [&](double b) {
        const double r = correlationLength / b;
        return std::sqrt(std::numbers::pi) * r * std::erf(1.0 / r) - r * r * (1.0 - std::exp(-1.0 / (r * r)));
    };
    const double lost = found.rms * std::sqrt(1.0 - share(3 * 12.5e-6) * share(3 * 10e-6));
    QVERIFY2(std::abs(found.lost - lost) < 0.1 * lost + 0.02e-9,
             qPrintable(QStringLiteral("%1 nm lost, %2 expected").arg(found.lost * 1e9).arg(lost * 1e9)));
    // 3 (lost/gap)^2 above 1 % under a gap of 10 nm.
    QCOMPARE(found.isResolved(), lost < 10e-9 * std::sqrt(0.01 / 3.0));
}

void TestDiskOnCells::aStepIsASixteenthOfAWave()
{
    Case c = overWaves(100e-6, 0.0);
    const double speed = diskVelocity(c.disk, length, width, 0.5 * length, 0.5 * width).x;
    QVERIFY(std::abs(seen(c).longestStep - 100e-6 / 16.0 / speed) < 1e-6 * seen(c).longestStep);
    c.diskSurface.waveAmplitudes = {0.09e-9}; // less than a hundredth of the gap
    QVERIFY(std::isinf(seen(c).longestStep) && !seen(c).coarsest);
    c.diskSurface.waveAmplitudes = {1e-9};
    c.diskSurface.waveLengths = {1.9 * 12.5e-6}; // of which the cells know too little
    QVERIFY(std::isinf(seen(c).longestStep));
    c.diskSurface.waveLengths = {100e-6};
    c.diskSurface.motion = SurfaceMotion::Still;
    QVERIFY(std::isinf(seen(c).longestStep));
    c.disk.speed = 0.0;
    c.diskSurface.motion = SurfaceMotion::Moving;
    QVERIFY(std::isinf(seen(c).longestStep));
}

void TestDiskOnCells::aStepFollowsNoWaveThatDoesNotMatter()
{
    Case c = plane();
    c.diskSurface.kind = DiskSurfaceKind::Rough;
    c.diskSurface.correlationLength = 60e-6;
    c.diskSurface.cell = 5e-6;
    c.diskSurface.track = 5e-3;
    c.diskSurface.trackWidth = 2e-3;
    const auto stepOf = [&](double rms) {
        c.diskSurface.rms = rms;
        return seen(c).longestStep;
    };
    // 3 (RMS/gap)^2 is below 1 % of 0.5 nm over 10 nm; the larger the rest, the shorter the waves that matter.
    QVERIFY(std::isinf(stepOf(0.5e-9)));
    QVERIFY(std::isfinite(stepOf(2e-9)) && stepOf(4e-9) <= stepOf(2e-9) && stepOf(8e-9) < stepOf(2e-9));
}

/// A profile that is quiet for 7/8 of its length and rough at its end.
void TestDiskOnCells::looksAtAllOfAMap()
{
    Case c = plane();
    c.diskSurface.kind = DiskSurfaceKind::File;
    HeightMap map;
    map.nx = 65536;
    map.ny = 1;
    map.dx = 1e-6;
    map.closedX = true;
    for (int i = 0; i < map.nx; ++i) map.heights.push_back(i < 7 * map.nx / 8 ? 0.0 : i % 8 < 4 ? 2e-9 : -2e-9);
    const Recess recess(c.surface, length, width);
    const DiskOnCells found = diskOnCells(c, DiskTopography(c.diskSurface, map), recess,
                                          uniformGrid(length, width, cells, cells), {10e-9, 0.0, 0.0});
    QVERIFY(!found.isResolved() && found.lost > 1e-9);
}

/// A wave that does not fit in the track has the RMS a/sqrt(2), wherever the map is looked at.
void TestDiskOnCells::aLongWaveCountsWithItsWholeLength()
{
    Case c = plane();
    c.diskSurface.kind = DiskSurfaceKind::Combined;
    c.diskSurface.rms = 0.3e-9;
    c.diskSurface.waveAmplitudes = {5e-9};
    for (const double waveLength : {0.4e-3, 10e-3}) {
        c.diskSurface.waveLengths = {waveLength};
        QVERIFY(std::abs(seen(c).rms / std::sqrt(0.09e-18 + 12.5e-18) - 1.0) < 2e-3);
    }
}

void TestDiskOnCells::saysBothNumbers()
{
    const auto says = [](const DiskOnCells& disk, double step, const std::vector<const char*>& parts) {
        for (const std::string& doubt : doubtsOnDisk(disk, step))
            if (std::ranges::all_of(parts, [&](const char* part) { return doubt.find(part) != std::string::npos; }))
                return true;
        return false;
    };
    QVERIFY(says(seen(overWaves(25e-6, 0.0)), 0.0, {"25 um", "span 2 cells", "64 %"}));
    const DiskOnCells fine = seen(overWaves(200e-6, 0.0));
    QVERIFY(doubtsOnDisk(fine, 0.9 * fine.longestStep).empty());
    QVERIFY(says(fine, 1.1 * fine.longestStep, {"run.step", "200 um"}));
    QVERIFY(doubtsOnDisk(seen(plane()), 1.0).empty()); // flat
}

void TestDiskOnCells::saysWhereADiskReachesTheSlider()
{
    // The crest of a wave of 100 um along x stands a quarter of it behind the nodes, 14 nm high under a gap of 10 nm.
    const Case c = overWaves(100e-6, 0.0, 14e-9);
    const DiskAtStart start = diskAtStart(c);
    for (const char* part : {"at the start", "14 nm", "10 nm", "no law of contact"})
        QVERIFY2(start.problem.find(part) != std::string::npos, start.problem.c_str());
    QVERIFY(diskAtStart(overWaves(100e-6, 0.0, 9.9e-9)).problem.empty());
    Case touching = c; // a law of contact carries it
    touching.contact = ContactKind::Elastic;
    QVERIFY(diskAtStart(touching).problem.empty());
    touching.contact = ContactKind::OnoYamane; // acts on the mean plane
    QVERIFY(diskAtStart(touching).problem.empty());
    QVERIFY(std::ranges::any_of(diskAtStart(touching).warnings, [](const std::string& each) {
        return each.find("does not see it") != std::string::npos;
    }));
    Case low = plane();
    low.initial.nominalTrailingEdgeHeight = -1e-9;
    QVERIFY(diskAtStart(low).problem.find("1 nm below it") != std::string::npos);
    QVERIFY(diskAtStart(plane()).problem.empty() && diskAtStart(plane()).warnings.empty());
    QVERIFY(!diskAtStart(overWaves(30e-6, 0.0)).warnings.empty()); // 2.4 cells
}

void TestDiskOnCells::aStaticStateSaysThatTheDiskIsHigher()
{
    const Case c = overWaves(100e-6, 0.0, 14e-9);
    QVERIFY(noteOnHighDisk(c, 13.9e-9).find("14 nm") != std::string::npos);
    QVERIFY(noteOnHighDisk(c, 14.1e-9).empty());
    Case touching = c;
    touching.contact = ContactKind::Elastic;
    QVERIFY(noteOnHighDisk(touching, 1e-9).empty());
    QVERIFY(noteOnHighDisk(plane(), 1e-9).empty());
    Case flying = test::smallSlider(33);
    flying.contact = noContact;
    flying.steady.stiffness = true;
    QCOMPARE(steady(flying).message.find("mean plane"), std::string::npos);
    flying.diskSurface = overWaves(100e-6, 0.0, 1e-6).diskSurface;
    QVERIFY(steady(flying).message.find("rises up to 1000 nm") != std::string::npos);
    QCOMPARE(steady(attitudeCase(flying)).message.find("mean plane"), std::string::npos);
}

TOUCHDOWN_TEST(TestDiskOnCells)

} // namespace test_disk_on_cells

#include "test_disk_on_cells.moc"
