// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/field_difference.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/physics/slider/surface_edit.h"
#include "core/simulation/static_state/film_setup.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_field_difference {

double largest(const std::vector<double>& values)
{
    double result = 0.0;
    for (const double value : values) result = std::max(result, std::abs(value));
    return result;
}

class TestFieldDifference : public QObject {
    Q_OBJECT

private slots:
    void ofAStateFromItselfIsNothing()
    {
        const Case c = test::smallSlider();
        const SteadyResult state = steady(c);
        const FieldDifference none = fieldDifference(c, state, c, state);
        QCOMPARE(none.pressure.size(), state.grid.cells());
        QCOMPARE(largest(none.pressure), 0.0);
        QVERIFY(largest(none.gap) < 1e-15); // to the round-off of recesses of some um
        QCOMPARE(largest(none.recess), 0.0);
    }

    /// The other attitude is known, so the difference of the gaps is a plane: also where grids and their steps differ.
    void gapsDifferByThePlaneBetweenTheAttitudes()
    {
        Case fine = test::smallSlider();
        fine.steady.fixedAttitude = true;
        Case coarse = fine;
        coarse.film.nodes = {33, 33};
        fine.initial.nominalTrailingEdgeHeight = 20e-9;
        coarse.initial.nominalTrailingEdgeHeight = 15e-9;
        fine.initial.pitch = coarse.initial.pitch + 10e-6;
        const SteadyResult first = steady(fine), second = steady(coarse);
        QVERIFY(first.grid.cells() != second.grid.cells());
        const FieldDifference difference = fieldDifference(fine, first, coarse, second);
        const auto nx = static_cast<std::size_t>(first.grid.nx());
        for (std::size_t cell = 0; cell < first.grid.cells(); ++cell) {
            const double x = first.grid.centreX(static_cast<int>(cell % nx));
            QVERIFY(std::abs(difference.gap[cell] - (5e-9 + 10e-6 * (fine.slider.length - x))) < 1e-14);
        }
        QCOMPARE(largest(difference.recess), 0.0);
        QVERIFY(largest(difference.pressure) > 1e4);
    }

    /// A rail is deeper by 0.1 um in the second shape: the gap there is as much smaller in the first, to 1 pm.
    void recessesOfOtherShapes()
    {
        Case first = test::smallSlider();
        first.steady.fixedAttitude = true;
        Case second = first;
        second.surface.rails[1].recess[0] += 0.1e-6;
        const SteadyResult a = steady(first), b = steady(second);
        const FieldDifference difference = fieldDifference(first, a, second, b);
        QVERIFY2(std::abs(*std::ranges::min_element(difference.gap) + 0.1e-6) < 1e-12,
                 qPrintable(QString::number(*std::ranges::min_element(difference.gap), 'g', 12)));
        QVERIFY(std::abs(*std::ranges::min_element(difference.recess) + 0.1e-6) < 1e-12);
        QVERIFY(*std::ranges::max_element(difference.recess) < 1e-12);
    }

    /// Ambient pressures are left out: what is shown is the pressure above ambient.
    void theAmbientPressureIsNoDifference()
    {
        const Case first = test::smallSlider();
        SteadyResult still;
        still.grid = {{0.0, 0.5 * first.slider.length, first.slider.length}, {0.0, first.slider.width}};
        still.pressure.assign(2, airOf(first.air).pressure);
        still.gap = still.recess = {0.0, 0.0};
        Case second = first;
        second.air.given.pressure *= 0.7;
        SteadyResult other = still;
        other.pressure.assign(2, airOf(second.air).pressure);
        QVERIFY(airOf(first.air).pressure != airOf(second.air).pressure);
        QCOMPARE(largest(fieldDifference(first, still, second, other).pressure), 0.0);
    }
};

TOUCHDOWN_TEST(TestFieldDifference)

} // namespace test_field_difference

#include "test_field_difference.moc"
