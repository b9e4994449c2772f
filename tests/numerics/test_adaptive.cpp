// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/adaptive.h"

#include <numbers>

#include <QTest>

#include "tests/support/allocation_count.h"
#include "tests/support/piecewise_oscillator.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_adaptive {

using Mode = PiecewiseOscillator::Mode;

/// Springs of 1 rad/s above and 5 rad/s below q = 0, lightly damped.
const PiecewiseOscillator smooth = smoothOscillator({0.3, 1.0, 0.1});
const PiecewiseOscillator bilinear = switchedOscillator({0.0, 1.0, 0.0}, {0.0, 25.0, 0.0});

IntegrationResult integrate(const PiecewiseOscillator& system, PiecewiseOscillator::State y, double until,
                            double tolerance, Log& log)
{
    return integrateAdaptive(system, Start<PiecewiseOscillator>{y, system.naiveMode(y, Mode::Upper)}, until,
                             {.tolerance = tolerance, .firstStep = 1e-3}, log);
}

class TestAdaptive : public QObject {
    Q_OBJECT

private slots:
    void errorFollowsTheTolerance()
    {
        const PiecewiseOscillator::State start{1.0, 0.0};
        const auto exact = PiecewiseOscillator::exact(smooth.upper, start, 20.0);
        double previous = 0.0;
        for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
            Log log;
            QCOMPARE(integrate(smooth, start, 20.0, tolerance, log).end, IntegrationEnd::Reached);
            QVERIFY(log.times.back() == 20.0); // to the bit
            const double error = (log.last() - exact).norm();
            QVERIFY(error < 30.0 * tolerance);
            // Error per step control: the global error goes with tolerance^(4/5) to tolerance^1.
            if (previous > 0.0) QVERIFY(std::abs(std::log(previous / error) / std::log(100.0) - 0.9) < 0.2);
            previous = error;
        }
    }

    /// The number of steps goes with tolerance^(-1/5): the method has order 5.
    void stepsFollowTheOrder()
    {
        Log coarse, fine;
        const auto a = integrate(smooth, {1.0, 0.0}, 200.0, 1e-6, coarse);
        const auto b = integrate(smooth, {1.0, 0.0}, 200.0, 1e-11, fine);
        const double order = 5.0 / std::log10(double(b.steps) / double(a.steps));
        QVERIFY2(std::abs(order - 5.0) < 0.35, qPrintable(QString::number(order)));
    }

    void denseOutput()
    {
        Log log;
        for (int i = 1; i < 1000; ++i) log.askedTimes.push_back(0.02 * i);
        integrate(smooth, {1.0, 0.0}, 20.0, 1e-9, log);
        QCOMPARE(log.dense.size(), log.askedTimes.size());
        double worst = 0.0;
        for (std::size_t i = 0; i < log.dense.size(); ++i)
            worst = std::max(
                worst, (log.dense[i] - PiecewiseOscillator::exact(smooth.upper, {1.0, 0.0}, log.askedTimes[i])).norm());
        QVERIFY2(worst < 1e-7, qPrintable(QString::number(worst)));
    }

    /// From rest at q = 1: down after pi/2, half a swing below takes pi/5, half a swing above pi.
    void switchesAreLocatedToRoundOff()
    {
        Log log;
        const auto result = integrate(bilinear, {1.0, 0.0}, 40.0, 1e-11, log);
        QCOMPARE(result.end, IntegrationEnd::Reached);
        double expected = 0.5 * std::numbers::pi;
        bool upper = false;
        for (const Log::Event& event : log.events) {
            QVERIFY2(std::abs(event.time - expected) < 1e-9, qPrintable(QString::number(event.time - expected)));
            QCOMPARE(event.upper, upper);
            expected += upper ? std::numbers::pi : 0.2 * std::numbers::pi;
            upper = !upper;
        }
        // Down at pi/2 + 1.2 pi k for k = 0..10, up at 0.7 pi + 1.2 pi k for k = 0..10 (the last at 39.90).
        QCOMPARE(log.events.size(), std::size_t{22});
        // At each switch a step ends, on the boundary to round-off.
        for (const Log::Event& event : log.events) {
            const auto at = std::find(log.times.begin(), log.times.end(), event.time);
            QVERIFY(at != log.times.end());
            QVERIFY(std::abs(log.states[static_cast<std::size_t>(at - log.times.begin())][0]) < 1e-14);
        }
    }

    /// With its switches located the method keeps its accuracy across them.
    void accuracyAcrossSwitches()
    {
        const double period = 1.2 * std::numbers::pi;
        for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
            Log log;
            integrate(bilinear, {1.0, 0.0}, 10.0 * period, tolerance, log);
            const double error = (log.last() - PiecewiseOscillator::State(1.0, 0.0)).norm();
            QVERIFY2(error < 300.0 * tolerance, qPrintable(QString::number(error)));
        }
    }

    /// The dip below zero lasts 2e-3 of the time of one swing and ends inside one step: q = 1 + a sin t with a = 1 +
    /// 1e-6.
    void aShortContactIsNotMissed()
    {
        const PiecewiseOscillator dipping = switchedOscillator({1.0, 1.0, 0.0}, {1.0, 1.0, 0.0});
        Log log;
        const double a = 1.0 + 1e-6;
        integrate(dipping, {1.0 + a, 0.0}, 6.0, 1e-9, log);
        QCOMPARE(log.events.size(), std::size_t{2});
        const double half = std::acos(1.0 / a);
        QVERIFY(std::abs(log.events[0].time - (std::numbers::pi - half)) < 1e-5);
        QVERIFY(std::abs(log.events[1].time - (std::numbers::pi + half)) < 1e-5);
        // The same swing that stays above by as much makes no event.
        Log above;
        integrate(dipping, {2.0 - 1e-6, 0.0}, 6.0, 1e-9, above);
        QCOMPARE(above.events.size(), std::size_t{0});
    }

    /// Pushed onto the boundary from both sides, and damped: ever more switches, and a sentence instead of an endless
    /// run.
    void chatteringEnds()
    {
        const PiecewiseOscillator sliding = switchedOscillator({-1.0, 0.0, 2.0}, {1.0, 0.0, 2.0});
        Log log;
        const auto result = integrate(sliding, {0.1, 0.0}, 100.0, 1e-8, log);
        QCOMPARE(result.end, IntegrationEnd::Chattering);
        QVERIFY(result.time < 100.0);
        QVERIFY(log.last().allFinite());
    }

    /// At rest on the boundary but for round-off, on either side, and pushed up by both laws: at most the one switch
    /// that is due.
    void aStartOnTheBoundaryIsNoChatter()
    {
        const PiecewiseOscillator pushed = switchedOscillator({1.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
        for (const double q : {-3e-15, -1e-16, -1e-30, 0.0, 1e-30, 1e-16, 3e-15}) {
            for (const Mode mode : {Mode::Upper, Mode::Lower}) {
                Log log;
                const auto result = integrateAdaptive(pushed, Start<PiecewiseOscillator>{{q, 0.0}, mode}, 2.0,
                                                      {.tolerance = 1e-8, .firstStep = 1e-3}, log);
                QCOMPARE(result.end, IntegrationEnd::Reached);
                QCOMPARE(log.events.size(), std::size_t{mode == Mode::Lower});
                QVERIFY(std::abs(log.last()[0] - 2.0) < 1e-13);
            }
        }
    }

    /// At 1e6 a second after a second of flight the boundary can be met to 1e-10 only, far more than the round-off of q
    /// = 0: still one switch, whichever side of the boundary the step ends on.
    void aFastCrossingIsOneSwitch()
    {
        const PiecewiseOscillator flight = switchedOscillator({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
        for (int i = 0; i < 100; ++i) {
            Log log;
            const double height = 1e6 * (1.0 + 0.0037 * i);
            QCOMPARE(integrate(flight, {height, -1e6}, 2.0, 1e-8, log).end, IntegrationEnd::Reached);
            QCOMPARE(log.events.size(), std::size_t{1});
            QVERIFY(std::abs(log.events[0].time - height / 1e6) < 1e-14);
        }
    }

    /// A state so large that its round-off exceeds the error wanted is followed to round-off, not given up.
    void aToleranceBelowRoundOffIsMetToRoundOff()
    {
        const PiecewiseOscillator oscillator = smoothOscillator({0.0, 1.0, 0.0});
        Log log;
        QCOMPARE(integrate(oscillator, {1e6, 0.0}, 20.0, 1e-14, log).end, IntegrationEnd::Reached);
        const auto exact = PiecewiseOscillator::exact(oscillator.upper, {1e6, 0.0}, 20.0);
        QVERIFY2((log.last() - exact).norm() < 1e-11 * 1e6, qPrintable(QString::number((log.last() - exact).norm())));
    }

    /// The hill of test_fixed_step, with a tolerance that controls nothing: still no step crosses with energy that it
    /// made.
    void aWallIsCrossedWithTheEnergyThatIsThere()
    {
        const PiecewiseOscillator hill = switchedOscillator({400.0, 400.0, 0.0}, {400.0, 400.0, 0.0}, true);
        Log log;
        integrateAdaptive(hill, Start<PiecewiseOscillator>{{1.5, -1.0}, Mode::Upper}, 10.0,
                          {.tolerance = 5.0, .firstStep = 0.4}, log);
        QVERIFY(log.events.size() > 10);
        for (const Log::Event& event : log.events) {
            const auto step =
                std::size_t(std::find(log.times.begin(), log.times.end(), event.time) - log.times.begin());
            QVERIFY(step > 0 && step < log.times.size());
            const double before = hill.energy(log.states[step - 1]);
            const double after = hill.energy(log.states[step]);
            QVERIFY(std::abs(after - before) <= 0.0101 * std::max(before, after));
        }
    }

    void blowUpEnds()
    {
        // q" = +1e6 q: e^1000 is no number.
        const PiecewiseOscillator unstable = smoothOscillator({0.0, -1e6, 0.0});
        Log log;
        const auto result = integrate(unstable, {1.0, 0.0}, 1.0, 1e-8, log);
        QVERIFY(result.end == IntegrationEnd::Diverged || result.end == IntegrationEnd::StepUnderflow);
        QVERIFY(result.time > 0.0 && result.time < 1.0);
        QVERIFY(log.last().allFinite());
    }

    void stopsWhenTold()
    {
        Log log;
        log.stopAfter = 7;
        const auto result = integrate(smooth, {1.0, 0.0}, 1e6, 1e-8, log);
        QCOMPARE(result.end, IntegrationEnd::Stopped);
        QCOMPARE(log.times.size(), std::size_t{7});
        QCOMPARE(result.time, log.times.back());
    }

    void stepsAllocateNothing()
    {
        EventCount recorder;
        const long long before = allocations;
        const auto result = integrateAdaptive(bilinear, Start<PiecewiseOscillator>{{1.0, 0.0}, Mode::Upper}, 1000.0,
                                              {.tolerance = 1e-9}, recorder);
        QCOMPARE(allocations - before, 0LL);
        QVERIFY(result.steps > 1000 && recorder.events > 100);
    }

    void repeatsToTheBit()
    {
        Log a, b;
        integrate(bilinear, {1.0, 0.0}, 40.0, 1e-8, a);
        integrate(bilinear, {1.0, 0.0}, 40.0, 1e-8, b);
        QVERIFY(a.times == b.times);
        QVERIFY(a.last() == b.last());
    }
};

TOUCHDOWN_TEST(TestAdaptive)

} // namespace test_adaptive

#include "test_adaptive.moc"
