// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

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
    void aTopEndsWhereItsWallBegins_data();
    void aTopEndsWhereItsWallBegins();
    void aCrownedSurfaceIsNearestInside();
    void isALowerCornerHoweverItIsTilted_data();
    void isALowerCornerHoweverItIsTilted();
    void aLevelPlaneBearsInItsCentre();
    void isNoneWithoutAnAttitude();
    void mayBeNegative();
    void aSymmetricEdgeBearsInItsMiddle();
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

void TestMinimumSpacing::aTopEndsWhereItsWallBegins_data()
{
    QTest::addColumn<double>("pitch");
    QTest::addColumn<double>("roll");
    QTest::addColumn<bool>("reversed");
    for (const bool reversed : {false, true})
        for (const double roll : {-3e-6, 0.0, 2e-6})
            for (const double pitch : {-100e-6, 100e-6})
                QTest::addRow("%g, %g urad, %d", 1e6 * pitch, 1e6 * roll, reversed) << pitch << roll << reversed;
}

/// A wall that reaches 0.5 um into its rail rises to 20 nm at the edge, far steeper than the rail is tilted: the lowest
/// point is a corner of the rectangle that is left of the top, 0.5 um inside.
void TestMinimumSpacing::aTopEndsWhereItsWallBegins()
{
    QFETCH(const double, pitch);
    QFETCH(const double, roll);
    QFETCH(const bool, reversed);
    AirBearingSurface surface = withRail();
    surface.walls = {{{-0.5e-6, 0.0, 1e-6}, {0.0, 20e-9, 1e-6}}};
    for (RailPoint& point : surface.rails[0].points) point.wall = 1;
    if (reversed) std::ranges::reverse(surface.rails[0].points);
    double lowest = 1.0;
    for (const double x : {0.2005e-3, 0.8995e-3})
        for (const double y : {0.1005e-3, 0.4995e-3})
            lowest = std::min(lowest, 10e-9 + pitch * (length - x) - roll * (y - 0.5 * width));
    const auto place = nearest(surface, {10e-9, pitch, roll});
    QVERIFY2(std::abs(place.spacing - lowest) < 3e-14, qPrintable(QString::number(place.spacing - lowest)));
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

TOUCHDOWN_TEST(TestMinimumSpacing)

} // namespace test_minimum_spacing

#include "test_minimum_spacing.moc"
