// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/steady_near.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QTest>

#include "core/physics/film/gaps/film_gaps.h"
#include "core/physics/slider/surface_edit.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_steady_near {

class TestSteadyNear : public QObject {
    Q_OBJECT

private slots:
    /// From itself it stays where it is.
    void staysAtItsState()
    {
        const Case c = test::smallSlider();
        const SteadyResult cold = steady(c);
        QCOMPARE(cold.status, SteadyStatus::Converged);
        const SteadyResult near = steadyNear(c, c, cold);
        QCOMPARE(near.status, SteadyStatus::Converged);
        QVERIFY(std::abs(near.minimumSpacing - cold.minimumSpacing) < 1e-5 * cold.minimumSpacing);
        QVERIFY(near.iterations <= 2);
        QVERIFY(near.grid.x == cold.grid.x);
        QCOMPARE(near.interestSpacing.size(), c.surface.pointsOfInterest.size());
    }
    /// The side rails move along x in steps of 0.5 um: the spacing is that of a solution from nothing within the error
    /// of the grid, and does not jump from step to step, as it would with a new grid for each. Second differences are
    /// what a smooth curve has little of.
    void aDragIsSmooth()
    {
        Case c = test::smallSlider();
        c.steady.stiffness = false;
        SteadyResult state = steady(c);
        std::vector<double> spacing{state.minimumSpacing};
        for (int i = 0; i < 16; ++i) {
            const Case before = c;
            c.surface = movedInPairs(c.surface, {{PartKind::Rail, 1}}, {-0.5e-6, 0.0}, c.slider.width, 1e-7);
            state = steadyNear(c, before, state);
            QCOMPARE(state.status, SteadyStatus::Converged);
            spacing.push_back(state.minimumSpacing);
        }
        double roughest = 0.0;
        for (std::size_t i = 1; i + 1 < spacing.size(); ++i)
            roughest = std::max(roughest, std::abs(spacing[i + 1] - 2.0 * spacing[i] + spacing[i - 1]));
        QVERIFY2(roughest < 0.02e-9, qPrintable(QString::number(roughest)));
        QVERIFY(std::abs(spacing.back() - spacing.front()) > 10.0 * roughest);
        const SteadyResult cold = steady(c);
        QVERIFY(std::abs(cold.minimumSpacing - state.minimumSpacing) <
                std::max(0.1e-9, cold.discretisationError.minimumSpacing));
    }
    /// Lines at 2 and 8 go with their edges; an edge that stays holds its line; those between are spread.
    void linesMoveWithEdges()
    {
        const std::vector<double> lines{0, 2e-5, 4e-5, 5e-5, 8e-5, 10e-5};
        const auto to = movedLines(lines, {2e-5, 8e-5, 3e-5}, {1.5e-5, 8.5e-5, 7e-5});
        QVERIFY(to.has_value());
        const std::vector<double> expected{0, 1.5e-5, 1.5e-5 + 7e-5 / 3, 5e-5, 8.5e-5, 10e-5};
        for (std::size_t i = 0; i < lines.size(); ++i) QVERIFY(std::abs((*to)[i] - expected[i]) < 1e-18);
        QVERIFY(movedLines(lines, {2e-5, 2e-5}, {1e-5, 2e-5}) == lines);
        QVERIFY(movedLines(lines, {}, {}) == lines);
        QVERIFY(!movedLines(lines, {2e-5}, {8.1e-5})); // past the others
        QVERIFY(!movedLines(lines, {2e-5}, {0.9e-5})); // too near to the border
    }
    void fromNothingItIsSteady()
    {
        const Case c = test::smallSlider();
        const SteadyResult cold = steady(c), near = steadyNear(c, c, {});
        QCOMPARE(near.minimumSpacing, cold.minimumSpacing);
        QVERIFY(near.stiffness.has_value() == cold.stiffness.has_value());
    }
    /// A change of the load leaves the gaps as they are; a moved rail, or a longer slider, has others.
    void handsTheGapsOnWhereTheSliderIsTheSame()
    {
        const Case c = test::smallSlider(33);
        const SteadyResult from = steady(c);
        QVERIFY(from.gaps && from.gaps->grid.x == from.grid.x && from.gaps->grid.y == from.grid.y);
        Case heavier = c, moved = c, longer = c;
        heavier.suspension.preload *= 1.01;
        moved.surface = movedInPairs(c.surface, {{PartKind::Rail, 1}}, {-0.5e-6, 0.0}, c.slider.width, 1e-7);
        longer.slider.length += 1e-6;
        QCOMPARE(steadyNear(heavier, c, from).gaps, from.gaps);
        for (const Case& other : {moved, longer}) {
            const SteadyResult near = steadyNear(other, c, from);
            QVERIFY(near.gaps && near.gaps != from.gaps);
            QCOMPARE(near.grid.x.back(), other.slider.length);
        }
    }
    /// Four times the load is no small change.
    void farAwayItIsSteady()
    {
        Case c = test::smallSlider();
        const Case before = c;
        const SteadyResult from = steady(c);
        c.suspension.preload *= 4.0;
        const SteadyResult cold = steady(c), near = steadyNear(c, before, from);
        QCOMPARE(near.status, cold.status);
        QVERIFY(std::abs(near.minimumSpacing - cold.minimumSpacing) < 0.1 * std::abs(cold.minimumSpacing));
    }
    void stops()
    {
        const Case c = test::smallSlider();
        const SteadyResult cold = steady(c);
        Case changed = c;
        changed.surface = moved(c.surface, {{PartKind::Rail, 4}}, {-5e-6, 0.0});
        const SteadyResult stopped = steadyNear(changed, c, cold, [](const SteadyProgress&) { return false; });
        QCOMPARE(stopped.status, SteadyStatus::Cancelled);
    }
};

TOUCHDOWN_TEST(TestSteadyNear)

} // namespace test_steady_near

#include "test_steady_near.moc"
