// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <random>

#include <QtTest>

#include "core/physics/slider/minimum_spacing.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_minimum_spacing {

class TestMinimumSpacing : public QObject {
    Q_OBJECT

private slots:
    void aPitchedPlaneIsNearestAtItsTrailingEdge();
    void aRailIsNearestAtItsRearCorner();
    void aCrownedSurfaceIsNearestInside();
    void isALowerCornerHoweverItIsTilted_data();
    void isALowerCornerHoweverItIsTilted();
    void aLevelPlaneBearsInItsCentre();
    void isNoneWithoutAnAttitude();
    void mayBeNegative();
    void aSymmetricEdgeBearsInItsMiddle();
    void aRailIsNearestWhereItsWallsBegin();
    void aRailUnderAnotherIsNearestWhereTheirEdgesCross();
    void noPointOfASliderWithWallsIsLower_data();
    void noPointOfASliderWithWallsIsLower();
    void nearbyAttitudesNeedNoSearch();
};

constexpr double length = 1e-3, width = 0.8e-3;

MinimumSpacing::Place nearest(const AirBearingSurface& surface, const Attitude& attitude)
{
    const Recess recess(surface, length, width);
    return MinimumSpacing(surface, recess).at(attitude);
}

AirBearingSurface withRail()
{
    AirBearingSurface surface;
    surface.baseRecess = 1e-6;
    surface.rails = {{.points = {{0.2e-3, 0.1e-3}, {0.9e-3, 0.1e-3}, {0.9e-3, 0.5e-3}, {0.2e-3, 0.5e-3}}}};
    return surface;
}

void TestMinimumSpacing::aPitchedPlaneIsNearestAtItsTrailingEdge()
{
    AirBearingSurface surface;
    surface.baseRecess = 0.0;
    // Rolled by +2 urad the outer edge is lower by 2e-6 * W/2 = 0.8 nm.
    const auto place = nearest(surface, {10e-9, 100e-6, 2e-6});
    QVERIFY(std::abs(place.spacing - 9.2e-9) < 1e-18);
    QCOMPARE(place.at.x, length);
    QCOMPARE(place.at.y, width);
}

void TestMinimumSpacing::aRailIsNearestAtItsRearCorner()
{
    // At (0.9, 0.5) mm: 10 nm + 100 urad * 0.1 mm - 2 urad * 0.1 mm = 10 + 10 - 0.2 nm. The sides of edges are sampled
    // 1e-10 m away, which 100 urad turn into 1e-14 m.
    const auto place = nearest(withRail(), {10e-9, 100e-6, 2e-6});
    QVERIFY(std::abs(place.spacing - 19.8e-9) < 2e-14);
    QVERIFY(std::abs(place.at.x - 0.9e-3) < 2e-10);
    QVERIFY(std::abs(place.at.y - 0.5e-3) < 2e-10);
}

void TestMinimumSpacing::aCrownedSurfaceIsNearestInside()
{
    AirBearingSurface surface;
    surface.baseRecess = 0.0;
    surface.crown = 20e-9;
    // h = 50 nm + 20 urad (L - x) - 80 nm X (1 - X), X = x/L: slope -20 nm - 80 nm (1 - 2 X) = 0 at X = 0.625, where
    // h = 50 + 7.5 - 18.75 = 38.75 nm. The lattice of 1/128 misses the place by at most 1/256: 80 nm/256^2 = 0.0012 nm.
    const auto place = nearest(surface, {50e-9, 20e-6, 0.0});
    QVERIFY(std::abs(place.spacing - 38.75e-9) < 0.0013e-9);
    QVERIFY(std::abs(place.at.x - 0.625e-3) < length / 128);
}

void TestMinimumSpacing::isALowerCornerHoweverItIsTilted_data()
{
    QTest::addColumn<double>("pitch");
    QTest::addColumn<double>("roll");
    for (const double pitch : {-200e-6, 0.0, 100e-6})
        for (const double roll : {-50e-6, 0.0, 3e-6})
            QTest::addRow("%g, %g urad", 1e6 * pitch, 1e6 * roll) << pitch << roll;
}

/// The lowest of the rail's four corners, as above; of a level edge any point. The rest is 1 um higher.
void TestMinimumSpacing::isALowerCornerHoweverItIsTilted()
{
    QFETCH(double, pitch);
    QFETCH(double, roll);
    double lowest = 1.0;
    for (const double x : {0.2e-3, 0.9e-3})
        for (const double y : {0.1e-3, 0.5e-3})
            lowest = std::min(lowest, 10e-9 + pitch * (length - x) - roll * (y - 0.5 * width));
    const auto place = nearest(withRail(), {10e-9, pitch, roll});
    QVERIFY2(std::abs(place.spacing - lowest) < 3e-14, qPrintable(QString::number(place.spacing - lowest)));
    QVERIFY(std::abs(10e-9 + pitch * (length - place.at.x) - roll * (place.at.y - 0.5 * width) - place.spacing) <
            1e-21);
}

/// All points bear alike: the lattice's are in the middle on the average.
void TestMinimumSpacing::aLevelPlaneBearsInItsCentre()
{
    AirBearingSurface surface;
    surface.baseRecess = 0.0;
    const auto place = MinimumSpacing(surface, Recess(surface, length, width)).bearing({5e-9, 0.0, 0.0}, 1e-11);
    QCOMPARE(place.spacing, 5e-9);
    QVERIFY(std::abs(place.at.x - 0.5 * length) < 1e-15 && std::abs(place.at.y - 0.5 * width) < 1e-15);
}

void TestMinimumSpacing::isNoneWithoutAnAttitude()
{
    QVERIFY(!(nearest(withRail(), {std::nan(""), 100e-6, 0.0}).spacing < 1.0));
}

void TestMinimumSpacing::mayBeNegative()
{
    const auto place = nearest(withRail(), {-30e-9, 100e-6, 0.0});
    QVERIFY(std::abs(place.spacing - -20e-9) < 2e-14);
}

void TestMinimumSpacing::aSymmetricEdgeBearsInItsMiddle()
{
    const AirBearingSurface surface = withRail();
    const Recess recess(surface, length, width);
    const MinimumSpacing spacing(surface, recess);
    // The trailing edge at x = 0.9 mm, from y = 0.1 to 0.5 mm. Over the depth of 0.01 nm 100 urad reach 1e-7 m.
    const auto level = spacing.bearing({10e-9, 100e-6, 0.0}, 1e-11);
    QVERIFY(std::abs(level.spacing - spacing.at({10e-9, 100e-6, 0.0}).spacing) < 1e-20);
    QVERIFY(std::abs(level.at.y - 0.3e-3) < 1e-9);
    QVERIFY(std::abs(level.at.x - 0.9e-3) < 1e-7);
    // Rolled so far that the other corner is forty depths higher, the lower one bears.
    QVERIFY(std::abs(spacing.bearing({10e-9, 100e-6, 1e-6}, 1e-11).at.y - 0.5e-3) < 0.01e-3);
}

void TestMinimumSpacing::aRailIsNearestWhereItsWallsBegin()
{
    // The walls begin 2 um inside the edges, where the top ends at (0.898, 0.498) mm: 10 nm + 100 urad 0.102 mm - 2
    // urad 0.098 mm = 10 + 10.2 - 0.196 nm. On the edge itself the wall is 100 nm higher.
    AirBearingSurface surface = withRail();
    surface.walls = {{.distance = {-2e-6, 0.0, 5e-6}, .recess = {0.0, 100e-9, 1e-6}}};
    for (RailPoint& point : surface.rails[0].points) point.wall = 1;
    const auto place = nearest(surface, {10e-9, 100e-6, 2e-6});
    QVERIFY2(std::abs(place.spacing - 20.004e-9) < 1e-15, qPrintable(QString::number(place.spacing)));
    QVERIFY(std::abs(place.at.x - 0.898e-3) < 1e-11 && std::abs(place.at.y - 0.498e-3) < 1e-11);
    // Where the edge across is vertical, the wall along it ends there.
    surface.rails[0].points[1].wall = 0;
    QVERIFY(std::abs(nearest(surface, {10e-9, 100e-6, 2e-6}).spacing - (10e-9 + 10e-9 - 0.196e-9)) < 1e-15);
}

void TestMinimumSpacing::aRailUnderAnotherIsNearestWhereTheirEdgesCross()
{
    // A deeper rail hides the rear of a pad. In shares of length and width their slanted edges are
    // y = 0.8 - 2/7 (x - 0.2) and x = 0.4 + 0.4 y: they cross at x = y = 2/3, the pad's rearmost point.
    // Another pad ends 0.5 um before it, so that the way downhill from there does not lead to it.
    AirBearingSurface surface;
    surface.baseRecess = 1e-6;
    const double l = 1e-3, w = 0.8e-3;
    surface.rails.push_back(
        {.points = {{0.2 * l, 0.1 * w}, {0.9 * l, 0.1 * w}, {0.9 * l, 0.6 * w}, {0.2 * l, 0.8 * w}}});
    surface.rails.push_back({.points = {{0.4 * l, 0.0}, {l, 0.0}, {l, w}, {0.8 * l, w}}, .recess = {0.5e-6}});
    const double rear = 2.0 / 3.0 * l - 0.5e-6;
    surface.rails.push_back({.points = {{0.3 * l, 0.9 * w}, {rear, 0.9 * w}, {rear, 0.95 * w}, {0.3 * l, 0.95 * w}}});
    const MinimumSpacing spacing(surface, Recess(surface, l, w));
    const MinimumSpacing::Place place = spacing.at({10e-9, 100e-6, 0.0});
    QVERIFY(std::abs(place.at.x - 2.0 / 3.0 * l) < 2e-9 && std::abs(place.at.y - 2.0 / 3.0 * w) < 2e-9);
    QVERIFY(std::abs(place.spacing - (10e-9 + 100e-6 * l / 3.0)) < 2e-14);
}

void TestMinimumSpacing::noPointOfASliderWithWallsIsLower_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 20; ++seed) QTest::addRow("seed %d", seed) << seed;
}

/// Slanted rails beside each other with walls inside and outside, some with a lip below the top, some that begin with a
/// step: no point of a lattice, nor of a finer one around its lowest, lies lower.
void TestMinimumSpacing::noPointOfASliderWithWallsIsLower()
{
    QFETCH(int, seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    AirBearingSurface surface;
    surface.baseRecess = 1e-6;
    for (int wall = 0; wall < 3; ++wall) {
        const double begin = -draw(0.2e-6, 8e-6), first = seed % 4 == 0 ? draw(0.0, 50e-9) : 0.0,
                     lip = seed % 3 == 0 ? -draw(1e-9, 20e-9) : draw(0.0, 20e-9);
        surface.walls.push_back({.distance = {begin, 0.5 * begin, 0.0, draw(1e-6, 10e-6)},
                                 .recess = {first, lip, draw(10e-9, 100e-9), 1e-6}});
    }
    for (int rail = 0; rail < 3; ++rail) {
        const double x0 = (0.05 + 0.3 * rail + draw(0.0, 0.03)) * length, x1 = x0 + draw(0.08, 0.22) * length,
                     y0 = draw(0.05, 0.6) * width, y1 = y0 + draw(0.08, 0.3) * width, slant = draw(-0.03, 0.03) * width;
        const auto wall = [&] { return static_cast<int>(draw(0.0, 3.999)); };
        surface.rails.push_back(
            {.points = {{x0, y0, wall()}, {x1, y0 + slant, wall()}, {x1, y1, wall()}, {x0, y1, wall()}}});
    }
    const Recess recess(surface, length, width);
    const MinimumSpacing spacing(surface, recess);
    const Attitude attitude{20e-9, draw(-50e-6, 200e-6), draw(-20e-6, 20e-6)};
    const auto gapAt = [&](double x, double y) {
        return recess.at(x, y) + attitude.height + attitude.pitch * (length - x) - attitude.roll * (y - 0.5 * width);
    };
    const MinimumSpacing::Place place = spacing.at(attitude);
    QVERIFY(std::abs(place.spacing - gapAt(place.at.x, place.at.y)) < 1e-18);
    constexpr int lattice = 700;
    double least = 1.0, x0 = 0.0, y0 = 0.0;
    const auto look = [&](double x, double y) {
        if (const double gap = gapAt(x, y); gap < least) {
            least = gap;
            x0 = x;
            y0 = y;
        }
    };
    for (int j = 0; j <= lattice; ++j)
        for (int i = 0; i <= lattice; ++i) look(length * i / lattice, width * j / lattice);
    for (double step = length / lattice; step > 1e-11; step *= 0.5)
        for (int turn = 0; turn < 4; ++turn)
            for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}})
                look(std::clamp(x0 + dx * step, 0.0, length), std::clamp(y0 + dy * step, 0.0, width));
    QVERIFY2(place.spacing <= least + 1e-13, qPrintable(QStringLiteral("%1 nm at (%2, %3) um, but %4 nm at (%5, %6) um")
                                                            .arg(place.spacing * 1e9)
                                                            .arg(place.at.x * 1e6)
                                                            .arg(place.at.y * 1e6)
                                                            .arg(least * 1e9)
                                                            .arg(x0 * 1e6)
                                                            .arg(y0 * 1e6)));
}

// About drawn attitudes, as long as no other place lies lower, and after moves that are too large for what is known.
void TestMinimumSpacing::nearbyAttitudesNeedNoSearch()
{
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> draw(-1.0, 1.0);
    const AirBearingSurface surface = withRail();
    const Recess recess(surface, length, width);
    const MinimumSpacing spacing(surface, recess);
    for (int slider = 0; slider < 20; ++slider) {
        const Attitude rest{20e-9, 100e-6 * draw(random), 20e-6 * draw(random)};
        NearbySpacing nearby(spacing, 2e-9), exact(spacing, 0.0);
        for (int k = 0; k < 40; ++k) {
            const double size = k < 30 ? 1e-9 : 20e-9; // [m]
            const Attitude at{rest.height + size * draw(random), rest.pitch + size / length * draw(random),
                              rest.roll + size / width * draw(random)};
            QCOMPARE(exact.at(at), spacing.at(at).spacing);
            QVERIFY2(std::abs(nearby.at(at) - spacing.at(at).spacing) < 1e-14,
                     qPrintable(QString("%1 %2: %3").arg(slider).arg(k).arg(nearby.at(at) - spacing.at(at).spacing)));
            // Whatever bears is among what is known; of a depth beyond it all points are looked at.
            for (const double depth : {1e-11, 1e-10, 1e-9}) {
                const MinimumSpacing::Place whole = spacing.bearing(at, depth), near = nearby.bearing(at, depth);
                QVERIFY(std::abs(near.spacing - whole.spacing) < 1e-14);
                QCOMPARE(near.at.x, whole.at.x);
                QCOMPARE(near.at.y, whole.at.y);
            }
        }
        const double far = 1e-9;
        QVERIFY(std::isnan(nearby.at({std::nan(""), rest.pitch, rest.roll})) ||
                !std::isfinite(nearby.at({std::nan(""), rest.pitch, rest.roll})));
        QVERIFY(std::abs(nearby.at({rest.height + far, rest.pitch, rest.roll}) -
                         spacing.at({rest.height + far, rest.pitch, rest.roll}).spacing) < 1e-14);
    }
}

TOUCHDOWN_TEST(TestMinimumSpacing)

} // namespace test_minimum_spacing

#include "test_minimum_spacing.moc"
