// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/edge_ridges.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <QTest>

#include "core/physics/film/film_grid.h"
#include "core/physics/slider/recess.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_edge_ridges {

constexpr double length = 1e-3, width = 0.8e-3; // [m]
constexpr double shelf = 0.2e-6;                // recess [m]

enum Wall { None, FromZero, FromShelf, Wide, Low };

/// A shelf of 0.4 mm x 0.3 mm, turned about the middle of the slider by an angle [rad], with these walls on its edges.
/// The base recess is 2 um. FromZero is shallower than the shelf from -0.3 um to 0.2 um, as it falls by 2 um over 2 um;
/// Wide from -6 um to 6 um.
AirBearingSurface shelfOf(std::array<Wall, 4> walls, double angle = 0.0, bool clockwise = false)
{
    AirBearingSurface surface;
    surface.baseRecess = 2e-6;
    surface.walls = {{.distance = {-0.3e-6, 0.0, 2e-6}, .recess = {0.0, 0.0, 2e-6}},
                     {.distance = {0.0, 2e-6}, .recess = {shelf, 2e-6}},
                     {.distance = {-6e-6, 0.0, 6e-6, 8e-6}, .recess = {0.0, 0.0, shelf, 2e-6}},
                     {.distance = {0.0, 2e-6}, .recess = {shelf - 0.1e-6, 2e-6}}};
    const std::array<std::pair<double, double>, 4> corners{
        {{-0.2e-3, -0.15e-3}, {0.2e-3, -0.15e-3}, {0.2e-3, 0.15e-3}, {-0.2e-3, 0.15e-3}}};
    Rail rail{.points = {}, .recess = {shelf}};
    const double c = std::cos(angle), s = std::sin(angle);
    for (std::size_t k = 0; k < 4; ++k) {
        const auto& [a, b] = corners[clockwise ? 3 - k : k];
        rail.points.push_back({0.5 * length + a * c - b * s, 0.5 * width + a * s + b * c, walls[k]});
    }
    surface.rails = {rail};
    return surface;
}

/// Points of the rails whose edges have an unresolved ridge on nx x ny equal cells.
std::vector<RailEdge> ridges(const AirBearingSurface& surface, int nx = 200, int ny = 160)
{
    return unresolvedRidges(surface, Recess(surface, length, width), uniformGrid(length, width, nx, ny));
}

class TestEdgeRidges : public QObject {
    Q_OBJECT

private slots:
    /// On cells of 5 um.
    void countsEdges_data()
    {
        QTest::addColumn<double>("angle"); // [deg]
        QTest::addColumn<bool>("clockwise");
        for (const double angle : {0.0, 3.0, 20.0, 45.0, 80.0})
            for (const bool clockwise : {false, true})
                QTest::addRow("%g deg, %s", angle, clockwise ? "clockwise" : "anticlockwise") << angle << clockwise;
    }
    void countsEdges()
    {
        QFETCH(const double, angle);
        QFETCH(const bool, clockwise);
        const double turn = angle * M_PI / 180.0;
        const auto edges = ridges(shelfOf({FromZero, FromShelf, FromZero, None}, turn, clockwise));
        QCOMPARE(edges.size(), std::size_t{2});
        QVERIFY(edges[0] == (RailEdge{0, 0}) && edges[1] == (RailEdge{0, 2}));
        QCOMPARE(ridges(shelfOf({FromShelf, FromShelf, FromShelf, FromShelf}, turn, clockwise)).size(), std::size_t{0});
        QCOMPARE(ridges(shelfOf({FromZero, FromZero, FromZero, FromZero}, turn, clockwise)).size(), std::size_t{4});
    }

    /// A ridge of 12 um on cells of 5 um and of 20 um; turned by 45 degrees, a cell of 10 um is 14 um across the edge.
    void resolvedRidgesDoNotCount()
    {
        const auto all = [](double angle) { return shelfOf({Wide, Wide, Wide, Wide}, angle); };
        QCOMPARE(ridges(all(0.0)).size(), std::size_t{0});
        QCOMPARE(ridges(all(0.0), 50, 40).size(), std::size_t{4});
        QCOMPARE(ridges(all(0.0), 200, 40).size(), std::size_t{2}); // the cells are long across y alone
        QCOMPARE(ridges(all(0.0), 100, 80).size(), std::size_t{0});
        QCOMPARE(ridges(all(M_PI / 4), 100, 80).size(), std::size_t{4});
    }

    /// The gap over a ridge of 0.1 um on a shelf of 0.2 um is that of the shelf less 0.1 um: 160 nm of 260 nm. No
    /// ridge, as twice the smaller gap exceeds the larger.
    void lowRidgesDoNotCount() { QCOMPARE(ridges(shelfOf({Low, Low, Low, Low})).size(), std::size_t{0}); }

    /// A pad of recess 0 over the first edge, wider than it.
    void coveredRidgesDoNotCount()
    {
        AirBearingSurface surface = shelfOf({FromZero, FromZero, None, None});
        const double x0 = 0.25e-3, x1 = 0.75e-3, y0 = 0.2e-3, y1 = 0.3e-3; // the edge: y = 0.25 mm
        surface.rails.push_back({.points = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, .recess = {0.0}});
        const auto edges = ridges(surface);
        QCOMPARE(edges.size(), std::size_t{1});
        QCOMPARE(edges[0].point, std::size_t{1});
    }

    /// A ramp, and a step at the base recess, have no walls.
    void railsWithoutWalls()
    {
        AirBearingSurface surface = shelfOf({FromZero, FromZero, FromZero, FromZero});
        surface.rails[0].recess = {surface.baseRecess};
        QCOMPARE(ridges(surface).size(), std::size_t{0});
        surface.rails[0].kind = RailKind::Ramp;
        surface.rails[0].recess = {shelf, shelf, shelf};
        QCOMPARE(ridges(surface).size(), std::size_t{0});
    }

    void widensTheWallsOfEdges()
    {
        const AirBearingSurface surface = shelfOf({FromZero, FromShelf, FromZero, None});
        const AirBearingSurface wider = withWiderWalls(surface, std::vector<RailEdge>{{0, 2}}, 2.0);
        const auto wallOf = [&](const AirBearingSurface& s, std::size_t point) {
            return s.walls[static_cast<std::size_t>(s.rails[0].points[point].wall - 1)];
        };
        QVERIFY(wallOf(wider, 0) == wallOf(surface, 0) && wallOf(wider, 1) == wallOf(surface, 1));
        QCOMPARE(wider.rails[0].points[3].wall, 0);
        QVERIFY(wallOf(wider, 2).distance == (std::vector{-0.6e-6, 0.0, 4e-6}));
        QVERIFY(wallOf(wider, 2).recess == wallOf(surface, 2).recess);
    }
};

TOUCHDOWN_TEST(TestEdgeRidges)

} // namespace test_edge_ridges

#include "test_edge_ridges.moc"
