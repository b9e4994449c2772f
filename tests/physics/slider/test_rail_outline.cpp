// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/rail_outline.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/support/random_surface.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_rail_outline {

/// A T, 4 wide and 4 high, its foot from 1 to 3.
const std::vector<RailPoint> letterT{{1, 0, 0}, {3, 0, 0}, {3, 3, 0}, {4, 3, 0},
                                     {4, 4, 0}, {0, 4, 0}, {0, 3, 0}, {1, 3, 0}};

class TestRailOutline : public QObject {
    Q_OBJECT

private slots:
    /// The number of strips changes nothing, one strip that ends below the outline neither.
    void containsWithItsBorder_data()
    {
        QTest::addColumn<int>("strips");
        QTest::addColumn<double>("width");
        QTest::newRow("one strip") << 1 << 4.0;
        QTest::newRow("strips on the corners") << 4 << 4.0;
        QTest::newRow("many strips") << 1000 << 4.0;
        QTest::newRow("outline beyond the strips") << 3 << 1.5;
    }
    void containsWithItsBorder()
    {
        QFETCH(int, strips);
        QFETCH(double, width);
        const RailOutline outline(letterT, strips, width);
        for (double x = -0.5; x <= 4.5; x += 0.25) {
            for (double y = -0.5; y <= 4.5; y += 0.25) {
                const bool foot = x >= 1.0 && x <= 3.0 && y >= 0.0 && y <= 3.0;
                const bool bar = x >= 0.0 && x <= 4.0 && y >= 3.0 && y <= 4.0;
                QVERIFY2(outline.contains(x, y) == (foot || bar), qPrintable(QString("(%1, %2)").arg(x).arg(y)));
            }
        }
    }

    /// Positive anticlockwise: the T has 2 * 3 + 4 * 1 = 10.
    void area()
    {
        QCOMPARE(signedArea(letterT), 10.0);
        std::vector<RailPoint> backwards(letterT.rbegin(), letterT.rend());
        QCOMPARE(signedArea(backwards), -10.0);
    }

    void repetitionsKeepTheWallOfTheEdgeWithALength()
    {
        const std::vector<RailPoint> points{{0, 0, 1}, {1, 0, 2}, {1, 0, 3}, {1, 0, 4}, {1, 1, 5}, {0, 0, 6}};
        const std::vector<RailPoint> expected{{0, 0, 1}, {1, 0, 4}, {1, 1, 5}};
        QVERIFY(withoutRepetitions(points) == expected);
    }

    /// An edge meets a box when one of its points, close to each other, lies in it; never the other way round.
    void edgeMeetsABox()
    {
        test::RandomSurface random(5);
        int met = 0;
        for (int i = 0; i < 2000; ++i) {
            const auto place = [&] { return random.uniform(0.0, 10.0); };
            const double low = place();
            const OutlineEdge edge = [&] {
                const double x0 = place(), x1 = place(), dy = place();
                return OutlineEdge{x0, low, x1 - x0, dy, std::min(x0, x1), std::max(x0, x1), low + dy};
            }();
            const double x = place(), y = place();
            const SurfaceBox box{x, x + 0.5 * place(), y, y + 0.5 * place()};
            bool inside = false;
            double nearest = 1e9; // of the points of the edge, to the box
            for (int k = 0; k <= 1000; ++k) {
                const double px = edge.x + edge.dx * k / 1000.0;
                const double py = edge.y + edge.dy * k / 1000.0;
                const double dx = std::max({0.0, box.x0 - px, px - box.x1});
                const double dy = std::max({0.0, box.y0 - py, py - box.y1});
                nearest = std::min(nearest, std::hypot(dx, dy));
                inside = nearest == 0.0;
                if (inside) break;
            }
            if (inside) QVERIFY(edge.meets(box));
            if (edge.meets(box)) QVERIFY(nearest < 0.02); // half a step of at most 14.2/1000, and its slant
            met += inside;
        }
        QVERIFY(met > 200);
    }
};

TOUCHDOWN_TEST(TestRailOutline)

} // namespace test_rail_outline

#include "test_rail_outline.moc"
