// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/lift_area.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_lift_area {

Rail rectangle(double x0, double y0, double x1, double y1, double recess)
{
    return {RailKind::Step, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {recess, 0.0, 0.0}};
}

class TestLiftArea : public QObject {
    Q_OBJECT

private slots:
    /// A slider of 1.0 mm x 0.8 mm with a base of 2 um, drawn rail by rail.
    void railByRail()
    {
        AirBearingSurface surface;
        const SurfacePoint middle{0.5e-3, 0.4e-3};
        QVERIFY(railsSurround(surface, middle)); // a plain plate
        surface.rails.push_back(rectangle(0.1e-3, 0.1e-3, 0.3e-3, 0.3e-3, 0.0));
        QVERIFY(!railsSurround(surface, middle)); // tips over its leading pad
        surface.rails.push_back(rectangle(0.8e-3, 0.1e-3, 0.9e-3, 0.2e-3, 0.2e-6));
        QVERIFY(!railsSurround(surface, middle)); // both rails lie below y = 0.3 mm: it rolls over
        surface.rails.push_back(rectangle(0.5e-3, 0.6e-3, 0.7e-3, 0.7e-3, 0.0));
        QVERIFY(railsSurround(surface, middle));
        surface.rails.pop_back();
        surface.rails.push_back(rectangle(0.5e-3, 0.6e-3, 0.7e-3, 0.7e-3, 3e-6)); // a pocket deeper than the base
        QVERIFY(!railsSurround(surface, middle));
    }
    /// A base near to the rails carries as well. Where the roll is held, the rails only have to lie before and behind.
    void whatElseCarries()
    {
        AirBearingSurface surface;
        surface.baseRecess = 0.0;
        surface.rails = {rectangle(0.8e-3, 0.3e-3, 0.9e-3, 0.5e-3, -20e-9)};
        const SurfacePoint middle{0.5e-3, 0.4e-3};
        QVERIFY(railsSurround(surface, middle));
        surface.baseRecess = 1e-6;
        QVERIFY(!railsSurround(surface, middle) && !railsSurround(surface, middle, true));
        surface.rails.push_back(rectangle(0.1e-3, 0.1e-3, 0.2e-3, 0.3e-3, 0.0));
        QVERIFY(!railsSurround(surface, {0.5e-3, 0.6e-3}) && railsSurround(surface, {0.5e-3, 0.6e-3}, true));
    }
    /// On the edge of the hull and at a corner the rails carry it.
    void onTheBorder()
    {
        AirBearingSurface surface;
        surface.rails = {rectangle(0.0, 0.0, 1e-3, 1e-3, 0.0)};
        QVERIFY(railsSurround(surface, {1e-3, 0.5e-3}));
        QVERIFY(railsSurround(surface, {1e-3, 1e-3}));
        QVERIFY(!railsSurround(surface, {1.001e-3, 1e-3}));
        QVERIFY(!railsSurround(surface, {2e-3, 0.0})); // beyond, in line with two corners
    }
    /// The hull of two rectangles, against another criterion: a point lies within the hull of points exactly where no
    /// direction separates it from all of them. 3600 directions are tried.
    void drawn()
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> place(0.0, 1e-3);
        int within = 0;
        for (int draw = 0; draw < 300; ++draw) {
            AirBearingSurface surface;
            for (int k = 0; k < 2; ++k) {
                const double x = place(random), y = place(random);
                surface.rails.push_back(rectangle(x, y, x + 0.2 * place(random), y + 0.2 * place(random), 0.0));
            }
            const SurfacePoint load{place(random), place(random)};
            double least = 1.0; // over all directions: how far the farthest corner lies beyond the load [m]
            for (int k = 0; k < 3600; ++k) {
                const double turn = k * 6.283185307179586 / 3600.0;
                double most = -1.0;
                for (const Rail& rail : surface.rails)
                    for (const RailPoint& p : rail.points)
                        most = std::max(most, (p.x - load.x) * std::cos(turn) + (p.y - load.y) * std::sin(turn));
                least = std::min(least, most);
            }
            if (std::abs(least) < 2e-6) continue; // too near to the border for the directions tried
            QCOMPARE(railsSurround(surface, load), least > 0.0);
            within += least > 0.0 ? 1 : 0;
        }
        QVERIFY2(within > 20 && within < 280, qPrintable(QString::number(within)));
    }
};

TOUCHDOWN_TEST(TestLiftArea)

} // namespace test_lift_area

#include "test_lift_area.moc"
