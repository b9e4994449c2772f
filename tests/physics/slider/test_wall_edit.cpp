// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/wall_edit.h"

#include <random>

#include <QTest>

#include "core/physics/slider/surface_check.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_wall_edit {

const WallProfile profile{{-2e-6, 0.0, 4e-6, 4e-6, 8e-6}, {0.0, 0.2e-6, 0.4e-6, 0.6e-6, 1e-6}};

class TestWallEdit : public QObject {
    Q_OBJECT

private slots:
    void move()
    {
        WallProfile moved = movedWallPoint(profile, 1, 1e-6, 0.3e-6);
        QCOMPARE(moved.distance[1], 1e-6);
        QCOMPARE(moved.recess[1], 0.3e-6);
        QVERIFY(movedWallPoint(moved, 1, 0.0, 0.2e-6) == profile);
        // Not past a neighbour, at the ends as far as wanted.
        QCOMPARE(movedWallPoint(profile, 1, 9e-6, 0.0).distance[1], 4e-6);
        QCOMPARE(movedWallPoint(profile, 1, -9e-6, 0.0).distance[1], -2e-6);
        QCOMPARE(movedWallPoint(profile, 0, -9e-6, 0.0).distance[0], -9e-6);
        QCOMPARE(movedWallPoint(profile, 4, 90e-6, 0.0).distance[4], 90e-6);
        QVERIFY(movedWallPoint(profile, 9, 0.0, 0.0) == profile);
    }
    /// A quarter of the way from (0, 0.2) to (4, 0.4) um the recess is 0.25 um.
    void addAndRemove()
    {
        const WallProfile more = withWallPoint(profile, 1e-6);
        QCOMPARE(placeOfPoint(profile, 1e-6), std::size_t(2));
        QCOMPARE(more.distance[2], 1e-6);
        QCOMPARE(more.recess[2], 0.25e-6);
        QVERIFY(withoutWallPoint(more, 2) == profile);
        QCOMPARE(withWallPoint(profile, -5e-6).recess.front(), 0.0);
        QCOMPARE(withWallPoint(profile, 9e-6).recess.back(), 1e-6);
        QCOMPARE(withWallPoint(profile, 4e-6).recess[4], 0.6e-6); // behind the vertical piece
    }
    void aNewPointAfterAnother()
    {
        QCOMPARE(distanceAfter(profile, 0), -1e-6);
        QCOMPARE(distanceAfter(profile, 2), 4e-6);
        QCOMPARE(distanceAfter(profile, 4), 12e-6);
    }
    void twoPointsRemain()
    {
        const WallProfile slope = slopedWall(0.1e-6, 2e-6);
        QCOMPARE(slope.distance.back(), 10e-6);
        QVERIFY(withoutWallPoint(slope, 0) == slope);
        QVERIFY(withoutWallPoint(profile, 7) == profile);
    }
    void profilesStayValid()
    {
        std::mt19937 engine(5);
        AirBearingSurface surface;
        surface.walls = {profile};
        WallProfile& wall = surface.walls[0];
        for (int i = 0; i < 500; ++i) {
            const std::size_t point = engine() % wall.distance.size();
            const double distance = 1e-8 * (double(engine() % 2000) - 500.0);
            switch (engine() % 3) {
            case 0: wall = movedWallPoint(wall, point, distance, 0.1 * distance); break;
            case 1: wall = withWallPoint(wall, distance); break;
            default: wall = withoutWallPoint(wall, point);
            }
            QVERIFY(surfaceProblems(surface).empty());
        }
    }
};

TOUCHDOWN_TEST(TestWallEdit)

} // namespace test_wall_edit

#include "test_wall_edit.moc"
