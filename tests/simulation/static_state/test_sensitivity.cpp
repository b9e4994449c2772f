// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/sensitivity.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QTest>

#include "core/simulation/static_state/steady_near.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_sensitivity {

class TestSensitivity : public QObject {
    Q_OBJECT

private slots:
    /// Against differences of states on the same grid, each solved anew: recesses by 0.1 nm, edges by 5 nm, which lie
    /// on lines of the grid and off them.
    void partsAgreeWithDifferences()
    {
        Case c = test::smallSlider();
        c.film.tolerance = 1e-11;
        c.steady.loadTolerance = 1e-11;
        const SteadyResult state = steady(c);
        QCOMPARE(state.status, SteadyStatus::Converged);
        PartSelection parts{{PartKind::Rail, 0}, {PartKind::Rail, 4}};
        for (std::size_t k = 0; k < 4; ++k) parts.insert({PartKind::Edge, 4, k});
        const std::vector<PartInfluence> found = shapeInfluence(c, state, parts);
        QCOMPARE(found.size(), parts.size());
        // The rear pad's edges: inner, trailing, outer, leading; outwards is -y, +x, +y, -x.
        const std::array<SurfaceShift, 4> out{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
        for (const PartInfluence& each : found) {
            const bool rail = each.part.kind == PartKind::Rail;
            const double step = rail ? 1e-10 : 0.5e-6;
            std::array<double, 2> spacing{}, pitch{};
            for (const int side : {0, 1}) {
                Case moved = c;
                const double by = side == 1 ? step : -step;
                if (rail)
                    moved.surface.rails[each.part.item].recess[0] += by;
                else
                    moved.surface = touchdown::moved(c.surface, {each.part},
                                                     {by * out[each.part.index].x, by * out[each.part.index].y});
                const SteadyResult near = steadyNear(moved, c, state);
                QCOMPARE(near.status, SteadyStatus::Converged);
                spacing[std::size_t(side)] = near.minimumSpacing;
                pitch[std::size_t(side)] = near.attitude.pitch;
            }
            const double slope = (spacing[1] - spacing[0]) / (2.0 * step), turn = (pitch[1] - pitch[0]) / (2.0 * step);
            const auto agrees = [&](double a, double b, double least) {
                return std::abs(a - b) <= 0.01 * std::max(std::abs(b), least);
            };
            const QString text = QStringLiteral("%1 %2: %3 %4, %5 %6")
                                     .arg(each.part.item)
                                     .arg(each.part.index)
                                     .arg(each.per.minimumSpacing)
                                     .arg(slope)
                                     .arg(each.per.pitch)
                                     .arg(turn);
            QVERIFY2(agrees(each.per.minimumSpacing, slope, rail ? 0.01 : 2e-5), qPrintable(text));
            QVERIFY2(agrees(each.per.pitch, turn, rail ? 1.0 : 0.01), qPrintable(text));
        }
    }
    void stops()
    {
        const Case c = test::smallSlider();
        const SteadyResult state = steady(c);
        int asked = 0;
        const auto found = shapeInfluence(c, state, {{PartKind::Rail, 0}, {PartKind::Rail, 1}, {PartKind::Rail, 2}},
                                          [&] { return ++asked < 2; });
        QCOMPARE(found.size(), std::size_t(1));
    }
};

TOUCHDOWN_TEST(TestSensitivity)

} // namespace test_sensitivity

#include "test_sensitivity.moc"
