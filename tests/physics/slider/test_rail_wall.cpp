// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/rail_wall.h"

#include <cmath>

#include <QTest>

#include "tests/support/random_surface.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_rail_wall {

const WallShape wide({{-4.0, 0.0, 20.0}, {0.1, 0.2, 1.0}});
const WallShape narrow({{-1.0, 10.0}, {0.1, 1.0}});
const WallShape outsideOnly({{0.0, 10.0}, {0.0, 1.0}});

SurfacePoint direction(double degrees)
{
    const double angle = degrees * 3.14159265358979323846 / 180.0;
    return {std::cos(angle), std::sin(angle)};
}

class TestRailWall : public QObject {
    Q_OBJECT

private slots:
    /// How far the border goes on beyond the corner per unit of height.
    void spread_data()
    {
        QTest::addColumn<double>("turn"); // by how much the outline turns [degrees]
        QTest::addColumn<const WallShape*>("shape");
        QTest::addColumn<const WallShape*>("neighbour");
        QTest::addColumn<double>("outside");
        QTest::addColumn<double>("inside");
        const WallShape* none = nullptr;
        const double root2 = std::sqrt(2.0);
        QTest::newRow("right angle, equal walls: the diagonal") << 90.0 << &wide << &wide << 1.0 << 1.0;
        // Outer ends meet at (10, 20) from the corner, inner ones at (-1, -4).
        QTest::newRow("right angle, narrower neighbour") << 90.0 << &wide << &narrow << 0.5 << 0.25;
        QTest::newRow("right angle, wider neighbour") << 90.0 << &narrow << &wide << 2.0 << 4.0;
        QTest::newRow("right angle, no neighbour") << 90.0 << &wide << none << 0.0 << 0.0;
        QTest::newRow("concave right angle") << -90.0 << &wide << &wide << -1.0 << -1.0;
        QTest::newRow("concave, narrower neighbour") << -90.0 << &wide << &narrow << -0.5 << -0.25;
        // tan(22.5 degrees) = sqrt 2 - 1.
        QTest::newRow("blunt, equal walls") << 45.0 << &wide << &wide << root2 - 1.0 << root2 - 1.0;
        QTest::newRow("sharp, equal walls") << 135.0 << &wide << &wide << root2 + 1.0 << root2 + 1.0;
        // The neighbour's extension leans over the wall, or away from it.
        QTest::newRow("blunt, no neighbour") << 45.0 << &wide << none << -1.0 << -1.0;
        QTest::newRow("sharp, no neighbour") << 135.0 << &wide << none << 1.0 << 1.0;
        QTest::newRow("straight on, equal walls") << 0.0 << &wide << &wide << 0.0 << 0.0;
        QTest::newRow("straight on, other neighbour") << 0.0 << &wide << &narrow << 0.0 << 0.0;
        QTest::newRow("straight on, no neighbour") << 0.0 << &wide << none << 0.0 << 0.0;
        QTest::newRow("no inside") << 90.0 << &outsideOnly << &wide << 2.0 << 0.0;
    }
    void spread()
    {
        QFETCH(double, turn);
        QFETCH(const WallShape*, shape);
        QFETCH(const WallShape*, neighbour);
        QFETCH(double, outside);
        QFETCH(double, inside);
        for (const double start : {0.0, 77.0, -160.0}) {
            for (const double way : {+1.0, -1.0}) { // anticlockwise, clockwise
                const WallSpread spread =
                    wallSpread(direction(start), direction(start + way * turn), way, *shape, neighbour);
                QVERIFY(std::abs(spread.outside - outside) < 1e-12);
                QVERIFY(std::abs(spread.inside - inside) < 1e-12);
            }
        }
    }

    /// Where a wall has a recess it meets every box around the point, is within its bounds, and no lower than promised;
    /// breaks stay within its bounds.
    void boxesAndBounds()
    {
        test::RandomSurface random(11);
        const double unit = 1e-6;
        const WallShape shape({{-3.0 * unit, 0.0, 8.0 * unit}, {0.1, 0.4, 0.3}});
        int held = 0;
        for (int i = 0; i < 20000; ++i) {
            const auto near = [&](double size) { return random.uniform(-size, size) * unit; };
            const RailPoint a{near(20), near(20), 0};
            const RailPoint b{near(20), near(20), 0};
            const WallSpread start{random.uniform(-3, 3), random.uniform(-3, 3)};
            const WallSpread end{random.uniform(-3, 3), random.uniform(-3, 3)};
            const RailWall wall(a, b, random.whole(0, 1) ? 1.0 : -1.0, shape, start, end, 0);
            const double x = near(30);
            const double y = near(30);
            const SurfaceBox box{x - random.uniform(0, 9) * unit, x + random.uniform(0, 9) * unit,
                                 y - random.uniform(0, 9) * unit, y + random.uniform(0, 9) * unit};
            const SurfaceBox bounds = wall.bounds();
            const bool within = x >= bounds.x0 && x <= bounds.x1 && y >= bounds.y0 && y <= bounds.y1;
            const double outside = wall.recessOutside(x, y);
            if (std::isfinite(outside)) {
                QVERIFY(within);
                QVERIFY(wall.meets(box, WallSide::Outside));
                QVERIFY(outside >= wall.lowestOutside(box));
                ++held;
            }
            if (wall.recessInside(x, y)) {
                QVERIFY(within);
                QVERIFY(wall.meets(box, WallSide::Inside));
                ++held;
            }
            for (const WallSide side : {WallSide::Outside, WallSide::Inside}) {
                std::vector<double> breaks;
                wall.breaks({ScanAxis::X, y, -60 * unit, 60 * unit}, side, breaks);
                for (const double s : breaks) QVERIFY(wall.meets({s, s, y, y}, side));
            }
        }
        QVERIFY(held > 1000);
    }
};

TOUCHDOWN_TEST(TestRailWall)

} // namespace test_rail_wall

#include "test_rail_wall.moc"
