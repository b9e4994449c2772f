// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/surface_edit.h"

#include <cmath>
#include <random>

#include <QTest>

#include "core/physics/slider/surface_check.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_edit {

constexpr double width = 0.8e-3; // [m]

Rail rectangle(double x0, double y0, double x1, double y1, double recess = 0.0)
{
    return {RailKind::Step, {{x0, y0, 1}, {x1, y0, 2}, {x1, y1, 3}, {x0, y1, 4}}, {recess, 0.0, 0.0}};
}

/// Two side rails that are mirror images, a middle pad that is its own, and one without an image.
AirBearingSurface sample()
{
    AirBearingSurface surface;
    surface.rails = {rectangle(0.1e-3, 0.05e-3, 0.6e-3, 0.15e-3), rectangle(0.1e-3, 0.65e-3, 0.6e-3, 0.75e-3),
                     rectangle(0.8e-3, 0.3e-3, 0.9e-3, 0.5e-3), rectangle(0.2e-3, 0.2e-3, 0.3e-3, 0.25e-3, 1e-7)};
    surface.walls.assign(4, {{0.0, 4e-6}, {0.0, 2e-6}});
    surface.pointsOfInterest = {{0.9e-3, 0.4e-3}, {0.1e-3, 0.1e-3}};
    return surface;
}

bool near(double a, double b) { return std::abs(a - b) < 1e-15; } // [m]
const RailPoint& corner(const AirBearingSurface& surface, std::size_t rail, std::size_t k)
{
    return surface.rails.at(rail).points.at(k);
}

class TestSurfaceEdit : public QObject {
    Q_OBJECT

private slots:
    void whatIsThere()
    {
        const AirBearingSurface surface = sample();
        QVERIFY(has(surface, {PartKind::Rail, 3}));
        QVERIFY(!has(surface, {PartKind::Rail, 4}));
        QVERIFY(has(surface, {PartKind::Edge, 0, 3}));
        QVERIFY(!has(surface, {PartKind::Corner, 0, 4}));
        QVERIFY(has(surface, {PartKind::Interest, 1}));
        QVERIFY(!has(surface, {PartKind::Interest, 2}));
    }
    /// Of four walls two are used, which keep their edges.
    void unusedWalls()
    {
        AirBearingSurface surface = sample();
        for (std::size_t i = 0; i < surface.walls.size(); ++i) surface.walls[i].recess[1] = 1e-6 * double(i);
        for (Rail& rail : surface.rails)
            for (RailPoint& point : rail.points) point.wall = point.wall == 4 ? 4 : point.wall == 2 ? 2 : 0;
        const AirBearingSurface less = withoutUnusedWalls(surface);
        QCOMPARE(less.walls, (std::vector<WallProfile>{surface.walls[1], surface.walls[3]}));
        for (std::size_t rail = 0; rail < surface.rails.size(); ++rail)
            for (std::size_t k = 0; k < 4; ++k) {
                const int before = corner(surface, rail, k).wall, after = corner(less, rail, k).wall;
                QCOMPARE(after, before == 4 ? 2 : before == 2 ? 1 : 0);
            }
        QCOMPARE(withoutUnusedWalls(less), less);
    }
    /// A rail, a corner of another one and a point of interest, by (10, -20) um; a corner that is meant twice moves
    /// once. Nothing else changes.
    void move()
    {
        const AirBearingSurface before = sample();
        const AirBearingSurface after = moved(before,
                                              {{PartKind::Rail, 2},
                                               {PartKind::Corner, 2, 1},
                                               {PartKind::Corner, 3, 2},
                                               {PartKind::Interest, 0},
                                               {PartKind::Rail, 9}},
                                              {10e-6, -20e-6});
        AirBearingSurface expected = before;
        expected.rails[2] = rectangle(0.81e-3, 0.28e-3, 0.91e-3, 0.48e-3);
        expected.rails[3].points[2] = {0.31e-3, 0.23e-3, 3};
        expected.pointsOfInterest[0] = {0.91e-3, 0.38e-3};
        QVERIFY(after == expected);
        QVERIFY(moved(before, {}, {1e-6, 1e-6}) == before);
    }
    /// An edge along y moves along x alone; both of two edges move as they are told.
    void edges()
    {
        const AirBearingSurface before = sample();
        AirBearingSurface after = moved(before, {{PartKind::Edge, 0, 1}}, {10e-6, 5e-6});
        QVERIFY(near(corner(after, 0, 1).x, 0.61e-3) && near(corner(after, 0, 2).x, 0.61e-3));
        QCOMPARE(corner(after, 0, 1).y, corner(before, 0, 1).y);
        QCOMPARE(corner(after, 0, 2).y, corner(before, 0, 2).y);
        QVERIFY(after.rails[0].points[0] == before.rails[0].points[0]);
        after = moved(before, {{PartKind::Edge, 0, 0}, {PartKind::Edge, 0, 1}}, {10e-6, 5e-6});
        for (const std::size_t k : {0, 1, 2}) QVERIFY(near(corner(after, 0, k).y - corner(before, 0, k).y, 5e-6));
        QVERIFY(corner(after, 0, 3) == corner(before, 0, 3));
    }
    /// The slanted edge from (300, 0) to (0, 300) um of a triangle moves outwards by 100 um: its legs grow by 100
    /// sqrt(2) um along x and y. A trapezium's neighbours lean.
    void aSlantedEdge()
    {
        AirBearingSurface surface;
        surface.rails = {{RailKind::Step, {{0, 0, 0}, {300e-6, 0, 0}, {0, 300e-6, 0}}, {}}};
        const double out = 100e-6 / std::sqrt(2.0);
        const AirBearingSurface after = moved(surface, {{PartKind::Edge, 0, 1}}, {out, out});
        QVERIFY(near(corner(after, 0, 1).x, 300e-6 + 100e-6 * std::sqrt(2.0)));
        QCOMPARE(corner(after, 0, 1).y, 0.0);
        QCOMPARE(corner(after, 0, 2).x, 0.0);
        QVERIFY(near(corner(after, 0, 2).y, 300e-6 + 100e-6 * std::sqrt(2.0)));
        // Along itself an edge does not move.
        const AirBearingSurface along = moved(surface, {{PartKind::Edge, 0, 1}}, {out, -out});
        QVERIFY(near(corner(along, 0, 1).x, 300e-6) && near(corner(along, 0, 2).y, 300e-6));

        surface.rails = {{RailKind::Step, {{0, 0, 0}, {400e-6, 0, 0}, {300e-6, 100e-6, 0}, {100e-6, 100e-6, 0}}, {}}};
        const AirBearingSurface lower = moved(surface, {{PartKind::Edge, 0, 2}}, {0.0, -50e-6});
        QVERIFY(near(corner(lower, 0, 2).x, 350e-6) && near(corner(lower, 0, 2).y, 50e-6));
        QVERIFY(near(corner(lower, 0, 3).x, 50e-6) && near(corner(lower, 0, 3).y, 50e-6));
    }
    /// A neighbour in line with the edge has no corner to slide on: it moves along the normal.
    void anEdgeInLine()
    {
        AirBearingSurface surface;
        surface.rails = {{RailKind::Step, {{0, 0, 0}, {100e-6, 0, 0}, {200e-6, 0, 0}, {200e-6, 90e-6, 0}}, {}}};
        const AirBearingSurface after = moved(surface, {{PartKind::Edge, 0, 0}}, {0.0, 10e-6});
        QVERIFY(near(corner(after, 0, 1).x, 100e-6) && near(corner(after, 0, 1).y, 10e-6));
        // Nor one that is nearly in line.
        surface.rails[0].points[2].y = 1e-9;
        QVERIFY(near(corner(moved(surface, {{PartKind::Edge, 0, 0}}, {0.0, 10e-6}), 0, 1).x, 100e-6));
        // A corner on top of the next one is no edge to move.
        surface.rails[0].points[1] = surface.rails[0].points[0];
        QVERIFY(moved(surface, {{PartKind::Edge, 0, 0}}, {1e-6, 1e-6}) == surface);
    }
    /// A corner in the first edge of a ramp, and one removed: the top stays where it was. The plane through (0, 0, 1),
    /// (1, 0, 2) and (1, 1, 3) um in units of 100 um is 1 + x + y.
    void aRampKeepsItsPlane()
    {
        AirBearingSurface surface;
        surface.rails = {
            {RailKind::Ramp, {{0, 0, 0}, {1e-4, 0, 0}, {1e-4, 1e-4, 0}, {0, 1e-4, 0}}, {1e-6, 2e-6, 3e-6}}};
        const AirBearingSurface more = withCorner(surface, 0, 0, {0.5e-4, 0.0});
        QVERIFY(near(more.rails[0].recess[1], 1.5e-6) && near(more.rails[0].recess[2], 2e-6));
        QCOMPARE(more.rails[0].recess[0], 1e-6);
        const AirBearingSurface fewer = without(surface, {{PartKind::Corner, 0, 1}});
        QVERIFY(near(fewer.rails[0].recess[1], 3e-6) && near(fewer.rails[0].recess[2], 2e-6));
        // The same of a plane that slopes along both, away from the origin: z = 0.5 um + 4e-3 x + 7e-3 y.
        const auto plane = [](const RailPoint& at) { return 0.5e-6 + 4e-3 * at.x + 7e-3 * at.y; };
        Rail sloping{RailKind::Ramp, {{2e-5, 3e-5, 0}, {1.2e-4, 5e-5, 0}, {9e-5, 1.4e-4, 0}, {1e-5, 1.1e-4, 0}}, {}};
        for (std::size_t k = 0; k < 3; ++k) sloping.recess[k] = plane(sloping.points[k]);
        AirBearingSurface alone;
        alone.rails = {sloping};
        for (const AirBearingSurface& each :
             {withCorner(alone, 0, 0, {7e-5, 3.5e-5}), withCorner(alone, 0, 1, {1.1e-4, 9e-5}),
              without(alone, {{PartKind::Corner, 0, 0}}), without(alone, {{PartKind::Corner, 0, 1}})})
            for (std::size_t k = 0; k < 3; ++k) QVERIFY(near(each.rails[0].recess[k], plane(each.rails[0].points[k])));
        // Mirror images have the same top, whatever corner comes first.
        surface.rails.push_back({RailKind::Ramp,
                                 {{1e-4, width, 0}, {1e-4, width - 1e-4, 0}, {0, width - 1e-4, 0}, {0, width, 0}},
                                 {2e-6, 3e-6, 2e-6}});
        QVERIFY(mirrorImages(surface, width, 1e-7)[0].has_value());
        surface.rails[1].recess[2] = 2.1e-6;
        QVERIFY(!mirrorImages(surface, width, 1e-7)[0].has_value());
    }
    void insertion()
    {
        const AirBearingSurface before = sample();
        const AirBearingSurface after = withCorner(before, 0, 3, {0.1e-3, 0.1e-3});
        QCOMPARE(after.rails[0].points.size(), std::size_t(5));
        QVERIFY(corner(after, 0, 4) == (RailPoint{0.1e-3, 0.1e-3, 4}));
        QVERIFY(without(after, {{PartKind::Corner, 0, 4}}) == before);
    }
    void removal()
    {
        const AirBearingSurface before = sample();
        AirBearingSurface expected = before;
        expected.rails[0].points.erase(expected.rails[0].points.begin() + 2);
        QVERIFY(without(before, {{PartKind::Corner, 0, 2}}) == expected);
        QVERIFY(without(before, {{PartKind::Edge, 0, 1}}) == expected);
        // A point of interest alone; what is not there is not removed.
        expected = before;
        expected.pointsOfInterest.erase(expected.pointsOfInterest.begin());
        QVERIFY(without(before, {{PartKind::Interest, 0}}) == expected);
        QVERIFY(without(before, {{PartKind::Corner, 9, 0}, {PartKind::Corner, 0, 9}, {PartKind::Rail, 9}}) == before);
        // Two of four corners leave no rail; rails and points of interest go by their numbers before.
        expected = before;
        expected.rails.erase(expected.rails.begin(), expected.rails.begin() + 2);
        expected.pointsOfInterest.erase(expected.pointsOfInterest.begin());
        QVERIFY(without(before, {{PartKind::Corner, 0, 0},
                                 {PartKind::Corner, 0, 3},
                                 {PartKind::Rail, 1},
                                 {PartKind::Interest, 0},
                                 {PartKind::Interest, 7}}) == expected);
    }
    void copies()
    {
        const AirBearingSurface before = sample();
        const AirBearingSurface after = withCopies(before, {{PartKind::Rail, 0}, {PartKind::Rail, 2}}, {0.0, 10e-6});
        QCOMPARE(after.rails.size(), std::size_t(6));
        for (std::size_t i = 0; i < 4; ++i) QVERIFY(after.rails[i] == before.rails[i]);
        QVERIFY(near(corner(after, 5, 0).y, corner(before, 2, 0).y + 10e-6));
        QCOMPARE(corner(after, 4, 2).wall, 3);
    }
    void order()
    {
        const AirBearingSurface before = sample();
        AirBearingSurface after = reordered(before, 0, 2);
        QVERIFY(after.rails[2] == before.rails[0] && after.rails[0] == before.rails[1]);
        QVERIFY(after.rails[3] == before.rails[3]);
        QVERIFY(reordered(after, 2, 0) == before);
        QVERIFY(reordered(before, 1, 1) == before);
    }
    void walls()
    {
        const AirBearingSurface after = withoutWall(sample(), 1);
        QCOMPARE(after.walls.size(), std::size_t(3));
        const std::array expected{1, 0, 2, 3};
        for (std::size_t k = 0; k < 4; ++k) QCOMPARE(corner(after, 2, k).wall, expected[k]);
        QVERIFY(surfaceProblems(after).empty());
    }
    /// From (100, 50) to (600, 50) um the normal is (0, -1); a slanted edge of 3 x 4 um.
    void normals()
    {
        AirBearingSurface surface = sample();
        const SurfaceShift below = edgeNormal(surface, {PartKind::Edge, 0, 0});
        QVERIFY(near(below.x, 0.0) && near(below.y, -1.0));
        surface.rails[0].points = {{0, 0, 0}, {3e-6, 4e-6, 0}, {0, 8e-6, 0}};
        const SurfaceShift slanted = edgeNormal(surface, {PartKind::Edge, 0, 0});
        QVERIFY(near(slanted.x, 0.8) && near(slanted.y, -0.6));
    }
    void edgeWalls()
    {
        const AirBearingSurface before = sample();
        AirBearingSurface after = withEdgeWall(before, {{PartKind::Edge, 0, 2}, {PartKind::Corner, 0, 1}}, 1);
        const std::array expected{1, 2, 1, 4};
        for (std::size_t k = 0; k < 4; ++k) QCOMPARE(corner(after, 0, k).wall, expected[k]);
        after = withEdgeWall(before, {{PartKind::Rail, 3}, {PartKind::Edge, 9, 0}}, 0);
        for (std::size_t k = 0; k < 4; ++k) QCOMPARE(corner(after, 3, k).wall, 0);
        QVERIFY(after.rails[2] == before.rails[2]);
    }
    void mirror()
    {
        const AirBearingSurface before = sample();
        const AirBearingSurface after = mirrored(before, {{PartKind::Rail, 3}, {PartKind::Interest, 1}}, width);
        QVERIFY(near(corner(after, 3, 0).y, 0.6e-3) && near(corner(after, 3, 2).y, 0.55e-3));
        QCOMPARE(corner(after, 3, 1).wall, 2);
        QVERIFY(near(after.pointsOfInterest[1].y, 0.7e-3));
        QVERIFY(after.rails[0] == before.rails[0]);
    }
    void images()
    {
        const auto found = mirrorImages(sample(), width, 1e-7);
        QCOMPARE(found.size(), std::size_t(4));
        QVERIFY(found[0] && found[0]->rail == 1);
        QCOMPARE(found[0]->corner, (std::vector<std::size_t>{3, 2, 1, 0}));
        QVERIFY(found[1] && found[1]->rail == 0);
        QVERIFY(found[2] && found[2]->rail == 2);
        QVERIFY(!found[3]);
        AirBearingSurface other = sample();
        other.rails[1].points[0].x += 0.2e-6;
        QVERIFY(!mirrorImages(other, width, 1e-7)[0]);
        other = sample();
        other.rails[1].recess[0] = 1e-9;
        QVERIFY(!mirrorImages(other, width, 1e-7)[0]);
        // A third one alike belongs to no pair.
        other = sample();
        other.rails.push_back(other.rails[0]);
        const auto three = mirrorImages(other, width, 1e-7);
        QVERIFY(three[0] && three[1] && !three[4]);
    }
    /// One corner of a side rail moves its image's; the middle pad's corners spread; the pad as a whole moves along x
    /// alone; both side rails together do so, too.
    void pairs()
    {
        const AirBearingSurface before = sample();
        const SurfaceShift by{10e-6, 5e-6};
        const auto shift = [&](const AirBearingSurface& after, std::size_t rail, std::size_t k) {
            return SurfaceShift{corner(after, rail, k).x - corner(before, rail, k).x,
                                corner(after, rail, k).y - corner(before, rail, k).y};
        };
        const auto is = [](SurfaceShift s, double x, double y) { return near(s.x, x) && near(s.y, y); };
        AirBearingSurface after = movedInPairs(before, {{PartKind::Corner, 0, 1}}, by, width, 1e-7);
        QVERIFY(is(shift(after, 0, 1), 10e-6, 5e-6) && is(shift(after, 1, 2), 10e-6, -5e-6));
        QVERIFY(is(shift(after, 1, 1), 0, 0) && is(shift(after, 0, 2), 0, 0));
        after = movedInPairs(before, {{PartKind::Corner, 2, 0}}, by, width, 1e-7);
        QVERIFY(is(shift(after, 2, 0), 10e-6, 5e-6) && is(shift(after, 2, 3), 10e-6, -5e-6));
        after = movedInPairs(before, {{PartKind::Rail, 2}}, by, width, 1e-7);
        for (std::size_t k = 0; k < 4; ++k) QVERIFY(is(shift(after, 2, k), 10e-6, 0));
        after = movedInPairs(before, {{PartKind::Rail, 0}, {PartKind::Rail, 1}}, by, width, 1e-7);
        for (const std::size_t rail : {0, 1})
            for (std::size_t k = 0; k < 4; ++k) QVERIFY(is(shift(after, rail, k), 10e-6, 0));
        after = movedInPairs(before, {{PartKind::Edge, 0, 1}}, by, width, 1e-7);
        QVERIFY(is(shift(after, 0, 1), 10e-6, 0) && is(shift(after, 1, 1), 10e-6, 0));
        after = movedInPairs(before, {{PartKind::Rail, 3}}, by, width, 1e-7);
        QVERIFY(after == moved(before, {{PartKind::Rail, 3}}, by));
        // A pair that is broken at either rail moves alone; the others do not.
        for (const std::size_t single : {0, 1}) {
            after = movedInPairs(before, {{PartKind::Rail, 0}}, by, width, 1e-7, {single});
            QVERIFY(after == moved(before, {{PartKind::Rail, 0}}, by));
            after = movedInPairs(before, {{PartKind::Corner, 2, 0}}, by, width, 1e-7, {single});
            QVERIFY(is(shift(after, 2, 3), 10e-6, -5e-6));
        }
    }
    /// A corner on the centre line stays there.
    void onTheCentreLine()
    {
        AirBearingSurface surface;
        surface.rails = {{RailKind::Step, {{0.1e-3, 0.3e-3, 0}, {0.2e-3, 0.4e-3, 0}, {0.1e-3, 0.5e-3, 0}}, {}}};
        const AirBearingSurface after = movedInPairs(surface, {{PartKind::Corner, 0, 1}}, {10e-6, 5e-6}, width, 1e-7);
        QVERIFY(near(corner(after, 0, 1).x, 0.21e-3));
        QCOMPARE(corner(after, 0, 1).y, 0.4e-3);
    }
    /// What is a pair stays one, whatever is moved.
    void pairsStayPairs()
    {
        std::mt19937 engine(3);
        AirBearingSurface surface = sample();
        for (int i = 0; i < 200; ++i) {
            const std::size_t rail = engine() % 3, k = engine() % 4;
            const auto kind = std::array{PartKind::Rail, PartKind::Edge, PartKind::Corner}[engine() % 3];
            const auto step = [&] { return (double(engine() % 2001) - 1000.0) * 1e-9; };
            const SurfaceShift by{step(), step()};
            surface = movedInPairs(surface, {{kind, rail, k}}, by, width, 1e-7);
            const auto found = mirrorImages(surface, width, 1e-10);
            QVERIFY(found[0] && found[0]->rail == 1 && found[2] && found[2]->rail == 2);
        }
    }
    void snapping()
    {
        const AirBearingSurface surface = sample();
        const SnapGrid grid{1e-3, width, 5e-6, 1e-6};
        const PartSelection moving{{PartKind::Corner, 3, 0}};
        const auto at = [&](double x, double y) { return snapped(surface, moving, {x, y}, grid); };
        SnappedPlace place = at(0.603e-3, 0.4026e-3);
        QCOMPARE(place.at.x, 0.6e-3);
        QVERIFY(place.x == SnapTarget::Corner);
        QVERIFY(place.xCorner == (SurfacePart{PartKind::Corner, 0, 1}));
        QCOMPARE(place.at.y, 0.4e-3);
        QVERIFY(place.y == SnapTarget::Centre);
        // The middle pad's corner (0.8, 0.3) mm has both; 0.3 mm is also the x of the last rail.
        place = at(0.8e-3 + 2e-6, 0.3e-3 - 2e-6);
        QVERIFY(place.xCorner == (SurfacePart{PartKind::Corner, 2, 0}) && place.xCorner == place.yCorner);
        // A corner on the border says less than the border.
        AirBearingSurface wide = surface;
        wide.rails[0].points[0].x = 0.0;
        QVERIFY(snapped(wide, moving, {1e-6, 0.02349e-3}, grid).x == SnapTarget::Border);
        place = at(0.9963e-3, 0.02349e-3);
        QCOMPARE(place.at.x, 1e-3);
        QVERIFY(place.x == SnapTarget::Border && place.y == SnapTarget::Raster);
        QCOMPARE(place.at.y, 0.023e-3);
        // A place on the raster is the number that a file would have.
        for (int i = 10; i < 990; ++i)
            QCOMPARE(snapped({}, {}, {i * 1e-6 + 0.2e-6, 0.1e-3}, grid).at.x,
                     (QByteArray::number(i) + "e-6").toDouble());
        // Not to itself, nor beyond the reach; without a raster the place remains.
        place = snapped(surface, moving, {0.2064e-3, 0.2064e-3}, {1e-3, width, 10e-6, 0.0});
        QCOMPARE(place.at.x, 0.2e-3); // its neighbour's
        place = snapped(surface, {{PartKind::Rail, 3}}, {0.2064e-3, 0.2064e-3}, {1e-3, width, 10e-6, 0.0});
        QCOMPARE(place.at.x, 0.2064e-3);
        QVERIFY(place.x == SnapTarget::None && place.y == SnapTarget::None);
    }
};

TOUCHDOWN_TEST(TestSurfaceEdit)

} // namespace test_surface_edit

#include "test_surface_edit.moc"
