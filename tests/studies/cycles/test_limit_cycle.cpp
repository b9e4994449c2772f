// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/limit_cycle.h"

#include <numbers>
#include <random>

#include <QTest>

#include "core/studies/cycles/bouncing_run.h"
#include "core/studies/cycles/bouncing_springs.h"
#include "core/studies/cycles/cycle_branches.h"
#include "core/studies/runs/measured_run.h"
#include "tests/support/bouncing_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_limit_cycle {

BouncingRun found(const Case& c, double duration = 1e-3)
{
    return searchCycle(BouncingSprings(c, sectionUnits(c)), 0.0, {.duration = duration});
}

/// Mean frequency of the upward crossings of the mean value, between samples by a straight line [Hz].
double frequencyOf(const std::vector<double>& time, const std::vector<double>& column, std::size_t begin)
{
    double mean = 0.0;
    for (std::size_t i = begin; i < column.size(); ++i) mean += column[i] / double(column.size() - begin);
    double first = 0.0, last = 0.0;
    int count = -1;
    for (std::size_t i = begin + 1; i < column.size(); ++i) {
        if (!(column[i - 1] < mean && column[i] >= mean)) continue;
        last = std::lerp(time[i - 1], time[i], (mean - column[i - 1]) / (column[i] - column[i - 1]));
        if (++count == 0) first = last;
    }
    return count > 0 ? count / (last - first) : 0.0;
}

/// z'' + 2 xi w z' + w^2 (z - rest) = 0 in closed form.
struct Oscillator {
    double w, xi; // [1/s], [-]
    std::pair<double, double> at(double z0, double v0, double rest, double t) const
    {
        const double damped = w * std::sqrt(1.0 - xi * xi), decay = std::exp(-xi * w * t);
        const double a = z0 - rest, b = (v0 + xi * w * a) / damped, co = std::cos(damped * t),
                     si = std::sin(damped * t);
        return {rest + decay * (a * co + b * si),
                decay * ((b * damped - xi * w * a) * co - (a * damped + xi * w * b) * si)};
    }
    /// The first time after which z passes `level` with the given direction.
    double passes(double z0, double v0, double rest, double level, bool upwards) const
    {
        const double step = 1e-3 * 2.0 * std::numbers::pi / w;
        const auto beyond = [&](double t) {
            const auto [z, v] = at(z0, v0, rest, t);
            return (z > level) == upwards && (v > 0.0) == upwards;
        };
        double t = step;
        while (!beyond(t)) t += step;
        double low = t - step, high = t;
        for (int k = 0; k < 60; ++k) (beyond(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
        return high;
    }
};

class TestLimitCycle : public QObject {
    Q_OBJECT

private slots:
    /// The relay oscillator in closed form: from d_s with the velocity v the spring's rest is raised by F/k until d_e,
    /// then falls back. The cycle is the v that returns; its multiplier is dv'/dv, and the pitch has a pair of
    /// magnitude exp(-xi w T).
    void relayOscillatorInClosedForm()
    {
        const Case c = relaySlider();
        const double rest = c.springs.flyingHeight, ds = c.onoYamane.touchDown, de = c.onoYamane.takeOff;
        const double raised =
            rest + (c.onoYamane.initialContactForce - c.onoYamane.meniscusForce) / c.suspension.stiffness;
        const Oscillator z{std::sqrt(c.suspension.stiffness / c.slider.mass), c.suspension.dampingRatio};
        double period = 0.0;
        const auto next = [&](double v) {
            const double on = z.passes(ds, v, raised, de, true);
            const auto [d, up] = z.at(ds, v, raised, on);
            const double off = z.passes(d, up, rest, ds, false);
            period = on + off;
            return z.at(d, up, rest, off).second;
        };
        double v = -5e-3;
        for (int k = 0; k < 300; ++k) v = next(v);
        const double slope = (next(v * 1.0001) - next(v * 0.9999)) / (0.0002 * v);
        next(v);

        const BouncingRun run = found(c);
        QVERIFY2(run.cycle.has_value(), run.problem.c_str());
        const LimitCycle& cycle = *run.cycle;
        QVERIFY(std::abs(cycle.period / period - 1.0) < 1e-9);
        QVERIFY(std::abs(cycle.x[1] * sectionUnits(c)[1] / v - 1.0) < 1e-8);
        const double pitch = std::sqrt(c.suspension.pitchStiffness / c.slider.pitchInertia);
        std::vector<double> expected{std::abs(slope), std::exp(-c.suspension.pitchDampingRatio * pitch * period)};
        expected.push_back(expected[1]);
        std::ranges::sort(expected, std::greater());
        for (std::size_t k = 0; k < 3; ++k)
            QVERIFY2(std::abs(std::abs(cycle.multipliers[k]) - expected[k]) < 1e-5,
                     qPrintable(QString("%1 %2").arg(std::abs(cycle.multipliers[k])).arg(expected[k])));
        QVERIFY(cycle.stable());
    }

    /// Cycles against the last tenth of long runs, where W < 0, with a fixed seed.
    void longRunsEndOnTheCycle_data()
    {
        QTest::addColumn<Case>("c");
        std::mt19937 random(7);
        const auto draw = [&](double least, double most) {
            return least + (most - least) * (double(random()) / double(std::mt19937::max()));
        };
        for (int k = 0; k < 6; ++k) {
            Case c = bouncingSlider(draw(0.2e-3, 1.5e-3));
            c.onoYamane.takeOff = draw(3.7e-9, 4.3e-9);
            c.springs.frontDampingRatio = c.springs.rearDampingRatio = draw(0.008, 0.05);
            c.springs.flyingHeight = draw(3.1e-9, 3.9e-9);
            c.onoYamane.friction = k % 2 == 0 ? 0.0 : draw(0.1, 1.0);
            QTest::addRow("f_m %.3g mN, d_e %.3g nm, xi %.2g, FH %.3g nm, mu %.2g", 1e3 * c.onoYamane.meniscusForce,
                          1e9 * c.onoYamane.takeOff, c.springs.rearDampingRatio, 1e9 * c.springs.flyingHeight,
                          c.onoYamane.friction)
                << c;
        }
    }
    void longRunsEndOnTheCycle()
    {
        QFETCH(Case, c);
        const BouncingRun run = found(c);
        QVERIFY2(run.cycle.has_value(), run.problem.c_str());
        const LimitCycle& cycle = *run.cycle;
        QVERIFY(cycle.stable());
        c.run.duration = 1e-3;
        c.run.sampleInterval = 20e-9;
        const MeasuredRun measured = measureRun(c, {"minimum_spacing"});
        QVERIFY(measured.valid());
        const std::vector<double>& spacing = measured.columns[0];
        const std::size_t begin = spacing.size() * 9 / 10;
        const double frequency = frequencyOf(measured.time, spacing, begin);
        const auto [least, most] = std::minmax_element(spacing.begin() + std::ptrdiff_t(begin), spacing.end());
        QVERIFY2(std::abs(cycle.frequency() / frequency - 1.0) < 1e-3, qPrintable(QString::number(frequency)));
        QVERIFY(std::abs(cycle.amplitude() / (0.5 * (*most - *least)) - 1.0) < 0.01);
        // Energy: the parts add up to zero, and the contact gives -W at each touch-down.
        QVERIFY2(cycle.residual() < 1e-8, qPrintable(QString::number(cycle.residual())));
        QVERIFY(std::abs(cycle.energies.contact / (-cycle.cycleWork * cycle.touchDowns) - 1.0) < 1e-8);
        QVERIFY(cycle.energies.air < 0.0 && cycle.energies.suspension < 0.0);
        QCOMPARE(cycle.energies.friction != 0.0, c.onoYamane.friction > 0.0);
    }

    /// A perturbation decays by the largest multiplier in each period.
    void perturbationsDecayByTheMultiplier()
    {
        Case c = bouncingSlider();
        c.springs.frontDampingRatio = c.springs.rearDampingRatio = 0.05;
        const LimitCycle cycle = *found(c).cycle;
        const BouncingSprings map(c, sectionUnits(c));
        Eigen::VectorXd x = cycle.x + Vector3(1e-4, 1e-4, 1e-4);
        std::vector<double> distance;
        for (int k = 0; k < 200; ++k) {
            const Return next = map.apply(x, {.limit = 1e-4});
            QVERIFY(next.returned);
            x = next.x;
            distance.push_back((x - cycle.x).norm());
        }
        // A complex pair turns the deviation: the mean over many periods.
        const double decay = std::pow(distance[160] / distance[40], 1.0 / 120.0);
        QVERIFY2(std::abs(decay - cycle.largestMultiplier()) < 0.01,
                 qPrintable(QString("%1 %2").arg(decay).arg(cycle.largestMultiplier())));
    }

    void newtonSaysWhyThereIsNone()
    {
        const Case c = bouncingSlider(10e-3);
        const BouncingSprings map(c, sectionUnits(c));
        const CycleSolution none =
            solveCycle(map, Vector3(map.coordinates(map.model().staticState())[0], -0.05, 0.0), 1, 1e-4);
        QVERIFY(!none.found);
        QVERIFY2(none.problem.starts_with("the slider does not come back") ||
                     none.problem.starts_with("Newton's method found no cycle of 1 crossing"),
                 none.problem.c_str());
    }

    /// Between its points a branch is straight: at 1.5 of 1 to 2, halfway. A cycle elsewhere, or with the figures of
    /// another place, does not lie on it.
    void aBranchHoldsTheCyclesBetweenItsPoints()
    {
        const auto cycleAt = [](double value, double figure) {
            LimitCycle cycle;
            cycle.value = value;
            cycle.period = figure * 1e-6;
            cycle.separation = {0.0, figure * 10e-9};
            cycle.minimumSpacing = {1e-9, 1e-9 + figure * 5e-9};
            return cycle;
        };
        for (const double last : {2.0, 0.5}) { // it may lead either way
            CycleBranch branch;
            branch.points = {cycleAt(1.0, 1.0), cycleAt(last, 3.0)};
            const double middle = 0.5 * (1.0 + last), quarter = std::lerp(1.0, last, 0.25);
            QVERIFY(liesOn(branch, cycleAt(middle, 2.0)));
            QVERIFY(liesOn(branch, cycleAt(quarter, 1.5)));
            QVERIFY(liesOn(branch, cycleAt(1.0, 1.0)));
            QVERIFY(liesOn(branch, cycleAt(last, 3.0)));
            QVERIFY(!liesOn(branch, cycleAt(middle, 1.0)));
            QVERIFY(!liesOn(branch, cycleAt(middle, 3.0)));
            QVERIFY(!liesOn(branch, cycleAt(std::lerp(1.0, last, 1.5), 4.0)));
        }
    }

    /// However short its period is, and however long it runs; the verdict is that on the newest samples.
    void aRunKeepsABoundedNumberOfSamples()
    {
        const Case c = bouncingSlider();
        const BouncingRun whole = found(c);
        QVERIFY(whole.samples > 4000);
        const BouncingRun bounded =
            searchCycle(BouncingSprings(c, sectionUnits(c)), 0.0, {.duration = 1e-3, .mostSamples = 1000});
        QVERIFY(bounded.samples >= 1000 && bounded.samples <= 2000);
        QCOMPARE(bounded.end, whole.end);
        QCOMPARE(bounded.frequency, whole.frequency);
        QVERIFY(BouncingSearch().mostSamples <= std::size_t{1} << 18);
    }

    void thePeriodIsTheShortest()
    {
        const Case c = bouncingSlider();
        const LimitCycle cycle = *found(c).cycle;
        QCOMPARE(cycle.crossings, 1);
        const CycleSolution twice = solveCycle(BouncingSprings(c, sectionUnits(c)), cycle.x, 2, 1e-4);
        QVERIFY2(twice.found, twice.problem.c_str());
        QCOMPARE(twice.crossings, 1);
    }
};

TOUCHDOWN_TEST(TestLimitCycle)

} // namespace test_limit_cycle

#include "test_limit_cycle.moc"
