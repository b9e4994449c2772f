// SPDX-License-Identifier: GPL-3.0-or-later
//
// Recesses derived by hand on small surfaces. Lengths are in micrometres, turned into metres on the way in.
#include "core/physics/slider/recess.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QTest>

#include "tests/support/allocation_count.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_recess {

constexpr double um = 1e-6;
constexpr double length = 200.0 * um;
constexpr double width = 100.0 * um;

struct Corner {
    double x, y; // [um]
    int wall = 0;
};

Rail step(std::initializer_list<Corner> corners, double recess)
{
    Rail rail;
    for (const Corner& c : corners) rail.points.push_back({c.x * um, c.y * um, c.wall});
    rail.recess[0] = recess * um;
    return rail;
}

Rail rectangle(double x0, double y0, double x1, double y1, int wall, double recess)
{
    return step({{x0, y0, wall}, {x1, y0, wall}, {x1, y1, wall}, {x0, y1, wall}}, recess);
}

/// The same polygon the other way round; the wall of each edge goes with it.
Rail reversed(const Rail& rail)
{
    Rail result = rail;
    const std::size_t count = rail.points.size();
    for (std::size_t i = 0; i < count; ++i) {
        result.points[i] = rail.points[count - 1 - i];
        result.points[i].wall = rail.points[(2 * count - 2 - i) % count].wall;
    }
    return result;
}

WallProfile wall(std::initializer_list<double> distance, std::initializer_list<double> recess)
{
    WallProfile profile{distance, recess};
    for (double& d : profile.distance) d *= um;
    for (double& r : profile.recess) r *= um;
    return profile;
}

/// Recesses rise by 0.1 um for each um from the edge, and end at a vertical step down to the base, 2 um.
const WallProfile wall10 = wall({0, 10}, {0, 1});

AirBearingSurface surfaceOf(std::vector<Rail> rails, std::vector<WallProfile> walls = {wall10})
{
    AirBearingSurface surface;
    surface.rails = std::move(rails);
    surface.walls = std::move(walls);
    surface.baseRecess = 2.0 * um;
    return surface;
}

double at(const AirBearingSurface& surface, double x, double y)
{
    return Recess(surface, length, width).at(x * um, y * um) / um;
}

bool near(double value, double expected) { return std::abs(value - expected) < 1e-9; }

std::vector<double> inMicrometres(std::vector<double> values)
{
    for (double& v : values) v = std::round(v / um * 1e9) / 1e9;
    return values;
}

class TestRecess : public QObject {
    Q_OBJECT

private slots:
    void theLastTopHolds()
    {
        const Rail shallow = rectangle(20, 20, 80, 60, 0, 0.1);
        const Rail deep = rectangle(50, 30, 120, 80, 0, 0.3);
        QCOMPARE(at(surfaceOf({shallow, deep}), 60, 50), 0.3);
        QCOMPARE(at(surfaceOf({deep, shallow}), 60, 50), 0.1);
        QCOMPARE(at(surfaceOf({shallow, deep}), 30, 50), 0.1);
        QCOMPARE(at(surfaceOf({shallow, deep}), 10, 50), 2.0);
        QCOMPARE(at(surfaceOf({rectangle(20, 20, 80, 60, 0, -0.25)}), 60, 50), -0.25);
        QCOMPARE(at(surfaceOf({rectangle(20, 20, 80, 60, 0, 3.5)}), 60, 50), 3.5);
    }

    /// 0.1, 0.5, 0.9 um at (20, 20), (60, 20), (60, 60): 0.01 per um in x and in y. At (50, 30): 0.1 + 0.3 + 0.1.
    void rampIsAPlane()
    {
        Rail ramp = step({{20, 20}, {60, 20}, {60, 60}, {20, 60}}, 0);
        ramp.kind = RailKind::Ramp;
        ramp.recess = {0.1 * um, 0.5 * um, 0.9 * um};
        QVERIFY(near(at(surfaceOf({ramp}), 50, 30), 0.5));
        QVERIFY(near(at(surfaceOf({ramp}), 20.5, 59.5), 0.1 + 0.005 + 0.395));
        QCOMPARE(at(surfaceOf({ramp}), 61, 30), 2.0);
    }

    void wallBesideEachEdge_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("expected");
        QTest::newRow("leading edge") << 77.0 << 50.0 << 0.3;
        QTest::newRow("trailing edge") << 123.0 << 50.0 << 0.3;
        QTest::newRow("inner edge") << 100.0 << 32.5 << 0.75;
        QTest::newRow("outer edge") << 100.0 << 69.0 << 0.9;
        QTest::newRow("end of the wall") << 130.0 << 50.0 << 1.0;
        QTest::newRow("beyond the wall") << 130.001 << 50.0 << 2.0;
        // (3, 4) and (-6, 8) from corners are 5 and 10 away; (8, 8) is 11.3 away.
        QTest::newRow("round corner, trailing, outer") << 123.0 << 64.0 << 0.5;
        QTest::newRow("round corner, leading, inner") << 77.0 << 36.0 << 0.5;
        QTest::newRow("just within the round corner") << 74.0 << 67.999 << 0.1 * std::hypot(6.0, 7.999);
        QTest::newRow("just beyond the round corner") << 74.0 << 68.001 << 2.0;
        QTest::newRow("outside the round corner") << 128.0 << 68.0 << 2.0;
        QTest::newRow("inside the rail") << 119.0 << 50.0 << 0.0;
    }
    void wallBesideEachEdge()
    {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, expected);
        const Rail rail = rectangle(80, 40, 120, 60, 1, 0.0);
        QVERIFY(near(at(surfaceOf({rail}), x, y), expected));
        QVERIFY(near(at(surfaceOf({reversed(rail)}), x, y), expected));
    }

    /// Recess 0.1 um per um of the wall of the first rail against tops that come later.
    void wallShowsWhereItIsShallower()
    {
        const Rail first = rectangle(20, 20, 60, 60, 1, 0.0);
        const AirBearingSurface deeper = surfaceOf({first, rectangle(60, 20, 100, 60, 0, 0.5)});
        QVERIFY(near(at(deeper, 63, 40), 0.3));
        QVERIFY(near(at(deeper, 67, 40), 0.5));
        const AirBearingSurface shallower = surfaceOf({first, rectangle(60, 20, 100, 60, 0, 0.1)});
        QVERIFY(near(at(shallower, 60.5, 40), 0.05));
        QVERIFY(near(at(shallower, 63, 40), 0.1));
        // A later top that covers part of the first rail is not raised there: a wall holds outside its own polygon.
        const AirBearingSurface overlapping = surfaceOf({first, rectangle(50, 20, 100, 60, 0, 0.5)});
        QVERIFY(near(at(overlapping, 55, 40), 0.5));
        QVERIFY(near(at(overlapping, 63, 40), 0.3));
        // Of two walls the shallower: 7 um from the first rail, 2 um from the second.
        const AirBearingSurface facing = surfaceOf({first, rectangle(69, 20, 100, 60, 1, 0.0)});
        QVERIFY(near(at(facing, 67, 40), 0.2));
    }

    /// A slot from x = 60 to 64, its left side with a wall that would reach x = 70: beyond the slot is the rail's own
    /// polygon, where a deeper top lies over it.
    void wallEndsAtItsOwnPolygon()
    {
        const Rail slotted =
            step({{20, 20}, {100, 20}, {100, 80}, {64, 80}, {64, 30}, {60, 30, 1}, {60, 80}, {20, 80}}, 0);
        Rail floored = slotted;
        std::swap(floored.points[5].wall, floored.points[4].wall); // the floor of the slot has one, not its side
        const Rail later = rectangle(50, 40, 90, 70, 0, 1.0);
        QVERIFY(near(at(surfaceOf({slotted, later}), 63, 50), 0.3));
        for (const double x : {64.01, 64.1, 66.0}) QVERIFY(near(at(surfaceOf({slotted, later}), x, 50), 1.0));
        QVERIFY(near(at(surfaceOf({floored, later}), 63, 50), 1.0));
        QVERIFY(near(at(surfaceOf({floored, later}), 63, 36), 0.6));
    }

    void noWallsOnRampsAndLowSteps()
    {
        Rail ramp = rectangle(20, 20, 60, 60, 1, 0.0);
        ramp.kind = RailKind::Ramp;
        QCOMPARE(at(surfaceOf({ramp}), 63, 40), 2.0);
        QCOMPARE(at(surfaceOf({rectangle(20, 20, 60, 60, 1, 2.0)}), 63, 40), 2.0);
        QCOMPARE(at(surfaceOf({rectangle(20, 20, 60, 60, 1, 2.5)}), 63, 40), 2.0);
        QVERIFY(near(at(surfaceOf({rectangle(20, 20, 60, 60, 1, 1.9)}), 63, 40), 0.3));
    }

    /// Right edge: 0.1 um per um up to 10 um; top edge: 0.05 um per um up to 20 um. At the corner (60, 60) the outer
    /// offset lines x = 70 and y = 80 meet at (10, 20) from it: the top wall holds beyond y = 2 x, the right one before
    /// it.
    void wallsOfUnequalWidthAtAConvexCorner()
    {
        const Rail rail = step({{20, 20}, {60, 20, 1}, {60, 60, 2}, {20, 60}}, 0);
        const AirBearingSurface surface = surfaceOf({rail}, {wall10, wall({0, 20}, {0, 1})});
        QVERIFY(near(at(surface, 63, 67), 0.05 * std::hypot(3.0, 7.0)));
        QVERIFY(near(at(surface, 63, 65), 0.1 * std::hypot(3.0, 5.0)));
        QVERIFY(near(at(surface, 64, 78), 0.05 * std::hypot(4.0, 18.0)));
        QVERIFY(near(at(surfaceOf({reversed(rail)}, surface.walls), 63, 67), 0.05 * std::hypot(3.0, 7.0)));
    }

    /// A concave corner at (60, 40): floor y = 40 with 0.1 um per um up to 20 um, side x = 60 with 0.05 um per um up to
    /// 10 um. The outer offset lines meet at (10, 20) from it. At (4, 6) the floor holds (border: y = 8), although the
    /// side's wall would be shallower, 0.2; at (2, 6) the side holds, 0.1.
    void wallsOfUnequalWidthAtAConcaveCorner()
    {
        const Rail rail = step({{20, 20}, {120, 20}, {120, 40, 1}, {60, 40, 2}, {60, 80}, {20, 80}}, 0);
        const AirBearingSurface surface = surfaceOf({rail}, {wall({0, 20}, {0, 2}), wall({0, 10}, {0, 0.5})});
        QVERIFY(near(at(surface, 64, 46), 0.6));
        QVERIFY(near(at(surface, 62, 46), 0.1));
        QVERIFY(near(at(surfaceOf({reversed(rail)}, surface.walls), 64, 46), 0.6));
    }

    /// The top edge ends at (60, 60). Its neighbour without a wall comes from (70, 40), so that its extension goes
    /// through (57.5, 65), or from (50, 40), through (62.5, 65), where the distance to the corner counts.
    void wallEndsOnTheExtensionOfAnEdgeWithoutOne()
    {
        const AirBearingSurface blunt = surfaceOf({step({{20, 40}, {70, 40}, {60, 60, 1}, {20, 60}}, 0)});
        QVERIFY(near(at(blunt, 57.4, 65), 0.5));
        QVERIFY(near(at(blunt, 57.6, 65), 2.0));
        const AirBearingSurface sharp = surfaceOf({step({{20, 40}, {50, 40}, {60, 60, 1}, {20, 60}}, 0)});
        QVERIFY(near(at(sharp, 62.4, 65), 0.1 * std::hypot(2.4, 5.0)));
        QVERIFY(near(at(sharp, 62.6, 65), 2.0));
        QVERIFY(near(at(sharp, 19.9, 65), 2.0)); // square to the edge
        QVERIFY(near(at(sharp, 20.1, 65), 0.5));
    }

    /// A profile from -4 um, 0.1 um, to 6 um, 1.1 um, inside the edge too; at the corner the two meet on the diagonal.
    void wallInsideItsOwnPolygon()
    {
        const Rail rail = rectangle(20, 20, 60, 60, 1, 0.1);
        const std::vector<WallProfile> walls{wall({-4, 6}, {0.1, 1.1})};
        const AirBearingSurface surface = surfaceOf({rail}, walls);
        QVERIFY(near(at(surface, 40, 40), 0.1));
        QVERIFY(near(at(surface, 57, 40), 0.2));
        QVERIFY(near(at(surface, 60, 40), 0.5)); // on the edge
        QVERIFY(near(at(surface, 63, 40), 0.8));
        QVERIFY(near(at(surface, 57, 58), 0.3)); // 3 um and 2 um inside: the nearer edge's
        QVERIFY(near(at(surface, 59, 58), 0.4));
        // A later top is not cut by it.
        QVERIFY(near(at(surfaceOf({rail, rectangle(50, 30, 59, 50, 0, 0.05)}, walls), 57, 40), 0.05));
        // Opposite walls in a rail 4 um wide, 1 um and 3 um away: the deeper holds, -1 um, 0.4.
        for (const double y : {21.0, 23.0})
            QVERIFY(near(at(surfaceOf({rectangle(20, 20, 60, 24, 1, 0.1)}, walls), 40, y), 0.4));
    }

    void collinearAndRepeatedPointsChangeNothing()
    {
        const Recess plain(surfaceOf({rectangle(20, 20, 60, 60, 1, 0.0)}), length, width);
        const Rail rail = step(
            {{20, 20, 1}, {33, 20, 1}, {60, 20, 1}, {60, 41, 1}, {60, 41, 1}, {60, 60, 1}, {20, 60, 1}, {20, 20, 1}},
            0);
        const Recess more(surfaceOf({rail}), length, width);
        for (double x = 9.3; x < 75.0; x += 1.7) {
            for (double y = 8.9; y < 75.0; y += 1.3)
                QVERIFY(near(plain.at(x * um, y * um) / um, more.at(x * um, y * um) / um));
        }
    }

    /// Where the outline runs straight on to an edge without a wall, the wall ends square to the edge.
    void wallEndsSquareAtACollinearPoint()
    {
        const AirBearingSurface surface = surfaceOf({step({{20, 20}, {60, 20}, {60, 60, 1}, {40, 60}, {20, 60}}, 0)});
        QVERIFY(near(at(surface, 40.1, 65), 0.5));
        QVERIFY(near(at(surface, 39.9, 65), 2.0));
    }

    /// A profile that is vertical at 5 um: the farther point holds there.
    void verticalProfile()
    {
        const AirBearingSurface surface =
            surfaceOf({rectangle(20, 20, 60, 60, 1, 0.0)}, {wall({0, 5, 5, 10}, {0, 0.2, 0.8, 1.0})});
        QVERIFY(near(at(surface, 64.999, 40), 0.2 * 4.999 / 5.0));
        QVERIFY(near(at(surface, 65.001, 40), 0.8 + 0.2 * 0.001 / 5.0));
        QVERIFY(near(at(surface, 40, 10), 1.0));
    }

    void outlineBelongsToItsRail()
    {
        const AirBearingSurface surface =
            surfaceOf({rectangle(20, 20, 60, 60, 0, 0.1), rectangle(60, 20, 100, 60, 0, 0.3)});
        for (const auto& [x, y] : {std::pair{20.0, 40.0}, {40.0, 20.0}, {40.0, 60.0}, {20.0, 20.0}, {20.0, 60.0}})
            QCOMPARE(at(surface, x, y), 0.1);
        for (const auto& [x, y] : {std::pair{60.0, 40.0}, {60.0, 20.0}, {60.0, 60.0}, {100.0, 60.0}, {100.0, 33.0}})
            QCOMPARE(at(surface, x, y), 0.3);
    }

    /// Right and left of the corners of a diamond that lie on the line to the point.
    void cornerOnTheLevelOfThePoint()
    {
        const AirBearingSurface surface = surfaceOf({step({{60, 20}, {80, 40}, {60, 60}, {40, 40}}, 0.1)});
        for (const double x : {40.0, 40.1, 60.0, 79.9, 80.0}) QCOMPARE(at(surface, x, 40), 0.1);
        for (const double x : {39.9, 80.1}) QCOMPARE(at(surface, x, 40), 2.0);
        for (const double x : {59.9, 60.1}) QCOMPARE(at(surface, x, 20), 2.0);
        for (const double x : {59.9, 60.1}) QCOMPARE(at(surface, x, 60), 2.0);
        QCOMPARE(at(surface, 60, 20), 0.1);
        QCOMPARE(at(surface, 60, 60), 0.1);
    }

    /// At x = L/4, y = W/4: 4 crown 3/16 + 4 camber 3/16 + 4 twist/16 = 0.75 * 15 + 0.75 * 4 + 0.25 * 8 nm = 16.25 nm.
    void form()
    {
        AirBearingSurface surface = surfaceOf({rectangle(20, 20, 60, 60, 0, 0.1)});
        surface.crown = 15e-9;
        surface.camber = 4e-9;
        surface.twist = 8e-9;
        QVERIFY(near(at(surface, 50, 25), 0.1 - 0.01625));
        QVERIFY(near(at(surface, 100, 50), 2.0 - 0.019)); // crown and camber in the middle
        QVERIFY(near(at(surface, 0, 0), 2.0 - 0.008));    // 4 twist/4 at a corner
    }

    /// 0.01 rad over 60 um: 0.4 um at x = 20 um. The form is taken off the tapered recess.
    void taper()
    {
        AirBearingSurface surface = surfaceOf({rectangle(0, 0, 200, 100, 0, 0.1)});
        surface.taperLength = 60 * um;
        surface.taperAngle = 0.01;
        QVERIFY(near(at(surface, 20, 50), 0.4));
        QVERIFY(near(at(surface, 0, 50), 0.6));
        QVERIFY(near(at(surface, 55, 50), 0.1)); // 0.05 um is less than the recess
        surface.crown = 0.08 * um;
        QVERIFY(near(at(surface, 50, 50), 0.1 - 0.06));
        QVERIFY(near(at(surface, 20, 50), 0.4 - 0.0288)); // 4 * 0.08 * 0.1 * 0.9
    }

    void besideTheSliderTheNearestPointCounts()
    {
        const AirBearingSurface surface = surfaceOf({rectangle(-50, 20, 60, 300, 0, 0.1)});
        QCOMPARE(at(surface, -5, 50), 0.1);
        QCOMPARE(at(surface, 40, 500), 0.1);
        QCOMPARE(at(surface, 1e9, -1e9), 2.0);
        QVERIFY(std::isnan(at(surface, std::numeric_limits<double>::quiet_NaN(), 50)));
    }

    /// The rectangle from 80 to 120, 40 to 60 with a profile of points at 0, 5 and 10 um.
    void breaks_data()
    {
        QTest::addColumn<bool>("alongX");
        QTest::addColumn<double>("fixed");
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::addColumn<QList<double>>("expected");
        QTest::newRow("across") << true << 50.0 << 60.0 << 140.0 << QList<double>{70, 75, 80, 120, 125, 130};
        QTest::newRow("upwards") << false << 100.0 << 20.0 << 80.0 << QList<double>{30, 35, 40, 60, 65, 70};
        QTest::newRow("ends are left out") << true << 50.0 << 75.0 << 120.0 << QList<double>{80};
        // 6 um above the edge the arc of 10 um is 8 um from the corner; the border of the walls is the diagonal.
        QTest::newRow("over the corners") << true << 66.0 << 60.0 << 140.0 << QList<double>{72, 74, 126, 128};
        // 4 um above, the arcs of 5 and 10 um are 3 and 9.165151390 um away.
        QTest::newRow("over two arcs") << true << 64.0 << 120.0 << 140.0 << QList<double>{123, 124, 129.16515139};
        QTest::newRow("beside the corners") << false << 126.0 << 20.0 << 80.0 << QList<double>{32, 34, 66, 68};
        QTest::newRow("clear of all") << true << 71.0 << 0.0 << 200.0 << QList<double>{};
        QTest::newRow("inside") << false << 100.0 << 41.0 << 59.0 << QList<double>{};
    }
    void breaks()
    {
        QFETCH(bool, alongX);
        QFETCH(double, fixed);
        QFETCH(double, from);
        QFETCH(double, to);
        QFETCH(QList<double>, expected);
        const std::vector<WallProfile> walls{wall({0, 5, 10}, {0, 0.7, 1.0})};
        for (const Rail& rail : {rectangle(80, 40, 120, 60, 1, 0.0), reversed(rectangle(80, 40, 120, 60, 1, 0.0))}) {
            const Recess recess(surfaceOf({rail}, walls), length, width);
            std::vector<double> out;
            if (alongX) {
                recess.breaksAlongX(fixed * um, from * um, to * um, out);
            } else {
                recess.breaksAlongY(fixed * um, from * um, to * um, out);
            }
            QCOMPARE(inMicrometres(out), std::vector<double>(expected.begin(), expected.end()));
        }
    }

    /// The taper of the case above ends at 60 um, and in the top of recess 0.1 um at 50 um; 2 um is never reached.
    void breaksOfTheTaper()
    {
        AirBearingSurface surface = surfaceOf({rectangle(0, 0, 200, 100, 0, 0.1)});
        surface.taperLength = 60 * um;
        surface.taperAngle = 0.01;
        const Recess recess(surface, length, width);
        std::vector<double> out{7.0};
        recess.breaksAlongX(50 * um, 10 * um, 190 * um, out);
        QCOMPARE(out.front(), 7.0); // appended
        QCOMPARE(inMicrometres({out.begin() + 1, out.end()}), (std::vector<double>{50, 60}));
        QVERIFY(recess.isSmooth(20 * um, 40 * um, 10 * um, 90 * um));
        QVERIFY(!recess.isSmooth(20 * um, 50 * um, 10 * um, 90 * um));
        QVERIFY(!recess.isSmooth(58 * um, 61 * um, 10 * um, 90 * um));
        QVERIFY(recess.isSmooth(61 * um, 190 * um, 10 * um, 90 * um));
    }

    void smoothAwayFromEdgesAndWalls()
    {
        const Recess recess(surfaceOf({rectangle(80, 40, 120, 60, 1, 0.0)}), length, width);
        QVERIFY(recess.isSmooth(81 * um, 119 * um, 41 * um, 59 * um)); // on the rail
        QVERIFY(recess.isSmooth(0, 69 * um, 0, 100 * um));             // on the base
        QVERIFY(recess.isSmooth(129 * um, 133 * um, 70.1 * um, 75 * um));
        QVERIFY(!recess.isSmooth(71 * um, 72 * um, 45 * um, 46 * um)); // on a wall
        QVERIFY(!recess.isSmooth(0, 71 * um, 0, 100 * um));
        QVERIFY(!recess.isSmooth(80 * um, 81 * um, 41 * um, 59 * um)); // touches an edge
        QVERIFY(!recess.isSmooth(0, 200 * um, 0, 100 * um));
    }

    /// A wall that no point of the surface can show makes no breaks: all of it lies below a shallower top.
    void hiddenWallsAreLeftOut()
    {
        const Recess recess(surfaceOf({rectangle(80, 40, 120, 60, 1, 0.0), rectangle(60, 20, 140, 80, 0, -0.1)}),
                            length, width);
        QVERIFY(recess.isSmooth(61 * um, 139 * um, 21 * um, 79 * um));
    }

    void evaluationAllocatesNothing()
    {
        const Recess recess(surfaceOf({rectangle(80, 40, 120, 60, 1, 0.0)}), length, width);
        const long long before = test::allocations;
        double sum = 0.0;
        for (double x = 0.0; x < length; x += 1.7 * um) sum += recess.at(x, 0.5 * x);
        QCOMPARE(test::allocations - before, 0LL);
        QVERIFY(sum > 0.0);
    }
};

TOUCHDOWN_TEST(TestRecess)

} // namespace test_recess

#include "test_recess.moc"
