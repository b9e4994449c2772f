// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <QtTest>

#include "core/physics/slider/disk_clearance.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_disk_clearance {

class TestDiskClearance : public QObject {
    Q_OBJECT

private slots:
    void overAFlatDiskIsTheMinimumSpacing();
    void ofAPlaneOverAWaveIsThatOfItsNearestCrest();
    void movesWithTheDisk();
    void mayBeNegative();
    void noPointIsLower_data();
    void noPointIsLower();
};

constexpr double length = 1e-3, width = 0.8e-3;

AirBearingSurface plane()
{
    AirBearingSurface surface;
    surface.baseRecess = 0.0;
    return surface;
}

DiskSurface wave(double amplitude, double waveLength, double angle)
{
    DiskSurface disk;
    disk.kind = DiskSurfaceKind::Waves;
    disk.waveAmplitudes = {amplitude};
    disk.waveLengths = {waveLength};
    disk.waveAngles = {angle};
    return disk;
}

struct Scene {
    AirBearingSurface surface;
    DiskTopography disk;
    Velocity velocity{};
    Recess recess{surface, length, width};
    MinimumSpacing spacing{surface, recess};
    DiskClearance clearance{recess, spacing, disk, velocity};
};

void TestDiskClearance::overAFlatDiskIsTheMinimumSpacing()
{
    Scene scene{plane(), {}, {}};
    const DiskClearance::Place place = scene.clearance.at({10e-9, 100e-6, 2e-6}, 0.0);
    QCOMPARE(place.gap, scene.spacing.at({10e-9, 100e-6, 2e-6}).spacing);
    QCOMPARE(place.diskHeight, 0.0);
}

void TestDiskClearance::ofAPlaneOverAWaveIsThatOfItsNearestCrest()
{
    // Along x the gap is h + theta (L - x) - a sin k x. With L = 1 mm and waves of 100 um the trailing edge stands at a
    // node, rising towards the leading edge: the least gap is where k a cos(k u) = -theta/... of u = L - x, the
    // distance to the trailing edge, h + theta u + a sin k u, at cos k u = -theta/(a k): in the first trough before the
    // edge.
    const double a = 5e-9, k = 2.0 * std::numbers::pi / 100e-6, theta = 50e-6, h = 20e-9;
    Scene scene{plane(), DiskTopography(wave(a, 100e-6, 0.0)), {}};
    const double at = (2.0 * std::numbers::pi - std::acos(-theta / (a * k))) / k;
    const double expected = h + theta * at + a * std::sin(k * at);
    const DiskClearance::Place place = scene.clearance.at({h, theta, 0.0}, 0.0);
    QVERIFY2(std::abs(place.gap - std::min(expected, h)) < 1e-14, qPrintable(QString::number(place.gap)));
}

void TestDiskClearance::movesWithTheDisk()
{
    // A level plane lies h - a above the only crest under it, a quarter of a wave behind the node, which moves along.
    Scene scene{plane(), DiskTopography(wave(5e-9, 1.2e-3, 0.0)), {10.0, 0.0}};
    for (const double shift : {0.0, 0.1e-3, 0.3e-3}) {
        const DiskClearance::Place place = scene.clearance.at({20e-9, 0.0, 0.0}, shift / 10.0);
        QVERIFY(std::abs(place.gap - 15e-9) < 1e-15);
        QVERIFY(std::abs(place.diskHeight - 5e-9) < 1e-15);
        QVERIFY(std::abs(place.at.x - (1.2e-3 / 4.0 + shift)) < 1e-7);
    }
}

void TestDiskClearance::mayBeNegative()
{
    Scene scene{plane(), DiskTopography(wave(30e-9, 0.5e-3, 0.0)), {}};
    QVERIFY(std::abs(scene.clearance.at({20e-9, 0.0, 0.0}, 0.0).gap + 10e-9) < 1e-15);
}

void TestDiskClearance::noPointIsLower_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 18; ++seed) QTest::addRow("seed %d", seed) << seed;
}

/// Rails with and without walls, tilts and disks drawn at random: the clearance is the gap of a point, and no point of
/// a lattice, nor of a finer one around it, lies lower by a thousandth of the RMS height of the disk.
void TestDiskClearance::noPointIsLower()
{
    QFETCH(int, seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    AirBearingSurface surface;
    surface.baseRecess = 1e-6;
    surface.crown = draw(0.0, 20e-9);
    surface.walls.push_back({.distance = {-1e-6, 0.0, 3e-6}, .recess = {0.0, 20e-9, 1e-6}});
    for (int rail = 0; rail < 4; ++rail) {
        const double x0 = draw(0.0, 0.8) * length, x1 = x0 + draw(0.02, 0.2) * length, y0 = draw(0.0, 0.8) * width,
                     y1 = y0 + draw(0.02, 0.2) * width, slant = draw(-0.05, 0.05) * width;
        surface.rails.push_back(
            {.points = {{x0, y0, seed % 2}, {x1, y0, seed % 2}, {x1, y1, seed % 2}, {x0, y1 + slant, seed % 2}}});
    }
    DiskSurface disk;
    double rms = 0.0;
    if (seed % 3 == 0) { // one to eight waves
        disk.kind = DiskSurfaceKind::Waves;
        double squares = 0.0;
        for (int k = 0; k < 1 + seed % 8; ++k) {
            disk.waveAmplitudes.push_back(draw(-3e-9, 3e-9));
            disk.waveLengths.push_back(std::exp(draw(std::log(1.3e-6), std::log(300e-6))));
            disk.waveAngles.push_back(draw(-1.6, 1.6));
            disk.wavePhases.push_back(draw(0.0, 6.28));
            squares += 0.5 * disk.waveAmplitudes.back() * disk.waveAmplitudes.back();
        }
        rms = std::sqrt(squares);
    } else if (seed % 3 == 1) {
        disk.kind = DiskSurfaceKind::Rough;
        rms = disk.rms = std::exp(draw(std::log(0.1e-9), std::log(3e-9)));
        disk.correlationLength = draw(2e-6, 20e-6);
        disk.cell = 0.5e-6;
        disk.track = 0.25e-3;
        disk.trackWidth = 0.1e-3;
        disk.seed = seed;
    } else {
        disk.kind = DiskSurfaceKind::Bumps;
        disk.bumpShape = BumpShape::Gaussian;
        disk.bumpHeights = {rms = draw(1e-9, 10e-9)};
        disk.bumpLengths = {draw(20e-6, 200e-6)};
        disk.bumpX = {draw(0.0, 0.5e-3)};
        disk.bumpY = {draw(0.0, 0.4e-3)};
        disk.track = 0.5e-3;
        disk.trackWidth = 0.4e-3;
    }
    const Attitude attitude{20e-9, draw(-20e-6, 200e-6), draw(-10e-6, 10e-6)};
    constexpr double time = 30e-6;
    const double shiftX = draw(0.0, 1e-3), shiftY = draw(-1e-4, 1e-4);
    Scene scene{surface, DiskTopography(disk), {shiftX / time, shiftY / time}};
    const auto gapAt = [&](double x, double y) {
        return scene.recess.at(x, y) + attitude.height + attitude.pitch * (length - x) -
               attitude.roll * (y - 0.5 * width) - scene.disk.height(x - shiftX, y - shiftY);
    };
    const DiskClearance::Place place = scene.clearance.at(attitude, time);
    QVERIFY(std::abs(place.gap - gapAt(place.at.x, place.at.y)) < 1e-18);
    // What it remembers of one attitude and time serves at others, nearby and far.
    for (const double size : {0.0, 0.5e-9, 1.5e-9, 30e-9}) {
        const Attitude moved{attitude.height + size * draw(-1.0, 1.0), attitude.pitch + size * draw(-1.0, 1.0) / length,
                             attitude.roll + size * draw(-1.0, 1.0) / width};
        const double then = time * draw(0.0, 3.0);
        Scene fresh{surface, DiskTopography(disk), {shiftX / time, shiftY / time}};
        const double known = scene.clearance.at(moved, then).gap, sought = fresh.clearance.at(moved, then).gap;
        QVERIFY2(std::abs(known - sought) <= 1e-3 * (scene.disk.highest() - scene.disk.lowest()),
                 qPrintable(QString("%1: %2, %3").arg(size).arg(known).arg(sought)));
    }

    constexpr int lattice = 700;
    double least = 1.0, x0 = 0.0, y0 = 0.0;
    for (int j = 0; j <= lattice; ++j)
        for (int i = 0; i <= lattice; ++i)
            if (const double gap = gapAt(length * i / lattice, width * j / lattice); gap < least) {
                least = gap;
                x0 = length * i / lattice;
                y0 = width * j / lattice;
            }
    for (int j = -100; j <= 100; ++j)
        for (int i = -100; i <= 100; ++i) {
            const double x = std::clamp(x0 + i * 0.02 * length / lattice, 0.0, length),
                         y = std::clamp(y0 + j * 0.02 * width / lattice, 0.0, width);
            least = std::min(least, gapAt(x, y));
        }
    QVERIFY2(place.gap <= least + 1e-3 * rms,
             qPrintable(QStringLiteral("%1 nm found, %2 nm there").arg(place.gap * 1e9).arg(least * 1e9)));
}

TOUCHDOWN_TEST(TestDiskClearance)

} // namespace test_disk_clearance

#include "test_disk_clearance.moc"
