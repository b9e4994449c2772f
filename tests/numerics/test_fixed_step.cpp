// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/fixed_step.h"

#include <numbers>

#include <QTest>

#include "tests/support/allocation_count.h"
#include "tests/support/piecewise_oscillator.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_fixed_step {

using Mode = PiecewiseOscillator::Mode;
using System = PiecewiseOscillator;

enum Method { Naive, Rk4Located, NewmarkLocated, NewmarkDamped };

const PiecewiseOscillator smooth = smoothOscillator({0.3, 1.0, 0.1});
const PiecewiseOscillator bilinear = switchedOscillator({0.0, 1.0, 0.0}, {0.0, 25.0, 0.0});

template <class Recorder>
IntegrationResult integrate(Method method, const System& system, System::State y, double until, double step,
                            Recorder& log)
{
    const Start<System> start{y, system.naiveMode(y, Mode::Upper)};
    const FixedStepOptions options{.step = step};
    switch (method) {
    case Naive: return integrateNaively(system, start, until, options, log);
    case Rk4Located: return integrateFixed(system, Rk4Stepper<System>(system), start, until, options, log);
    case NewmarkLocated: return integrateFixed(system, NewmarkStepper<System>(system, {}), start, until, options, log);
    case NewmarkDamped:
        return integrateFixed(system, NewmarkStepper<System>(system, {.beta = 0.3025, .gamma = 0.6}), start, until,
                              options, log);
    }
    return {};
}

void methodRows()
{
    QTest::addColumn<int>("method");
    QTest::newRow("rk4") << int(Naive);
    QTest::newRow("rk4-events") << int(Rk4Located);
    QTest::newRow("newmark") << int(NewmarkLocated);
}

class TestFixedStep : public QObject {
    Q_OBJECT

private slots:
    void stepCount()
    {
        QCOMPARE(touchdown::stepCount(2e-3, 1e-8), 200000LL);
        QCOMPARE(touchdown::stepCount(1.0, 0.3), 4LL);
        QCOMPARE(touchdown::stepCount(1.0, 5.0), 1LL);
    }

    void orderOnASmoothSystem_data()
    {
        QTest::addColumn<int>("method");
        QTest::addColumn<double>("order");
        QTest::newRow("rk4") << int(Naive) << 4.0;
        QTest::newRow("rk4-events") << int(Rk4Located) << 4.0;
        QTest::newRow("newmark 1/4, 1/2") << int(NewmarkLocated) << 2.0;
        QTest::newRow("newmark with gamma 0.6") << int(NewmarkDamped) << 1.0;
    }
    void orderOnASmoothSystem()
    {
        QFETCH(int, method);
        QFETCH(double, order);
        const System::State start{1.0, 0.0};
        const auto exact = System::exact(smooth.upper, start, 10.0);
        std::array<double, 3> error{};
        for (std::size_t i = 0; i < 3; ++i) {
            Log log;
            integrate(Method(method), smooth, start, 10.0, 0.02 / double(1 << i), log);
            error[i] = (log.last() - exact).norm();
        }
        for (std::size_t i = 0; i < 2; ++i) {
            const double observed = observedOrder(error[i], error[i + 1]);
            QVERIFY2(std::abs(observed - order) < 0.15, qPrintable(QString::number(observed)));
        }
    }

    /// Ten periods of the bilinear oscillator end where they began. Located switches keep the order.
    void orderAcrossLocatedSwitches_data()
    {
        QTest::addColumn<int>("method");
        QTest::addColumn<double>("order");
        QTest::newRow("rk4-events") << int(Rk4Located) << 4.0;
        QTest::newRow("newmark") << int(NewmarkLocated) << 2.0;
    }
    void orderAcrossLocatedSwitches()
    {
        QFETCH(int, method);
        QFETCH(double, order);
        const double until = 12.0 * std::numbers::pi;
        std::array<double, 3> error{};
        for (std::size_t i = 0; i < 3; ++i) {
            Log log;
            integrate(Method(method), bilinear, {1.0, 0.0}, until, until / (4000.0 * double(1 << i)), log);
            error[i] = (log.last() - System::State(1.0, 0.0)).norm();
            QCOMPARE(log.events.size(), std::size_t{20});
        }
        const double observed = 0.5 * observedOrder(error[0], error[2]);
        QVERIFY2(std::abs(observed - order) < 0.15, qPrintable(QString::number(observed)));
    }

    /// A jump of the force, found by looking at the state between steps: what the paper does has order 1.
    void naiveSwitchingHasOrderOne()
    {
        const PiecewiseOscillator jump = switchedOscillator({-1.0, 0.0, 0.0}, {2.0, 0.0, 0.0});
        // From rest at 1: falls for sqrt 2 s, then decelerates; after t > sqrt 2: q = -sqrt2 s + s^2 with s = t -
        // sqrt 2.
        const auto errorOf = [&](Method method, double step) {
            Log log;
            integrate(method, jump, {1.0, 0.0}, 2.0, step, log);
            const double s = 2.0 - std::numbers::sqrt2;
            return std::abs(log.last()[0] - (s * s - std::numbers::sqrt2 * s));
        };
        // The error of one step size is a matter of where the switch falls within a step; the mean over many is not.
        const auto mean = [&](double step) {
            double sum = 0.0;
            for (int i = 0; i < 64; ++i) sum += errorOf(Naive, step * (1.0 + 0.01 * i));
            return sum / 64.0;
        };
        const double observed = 0.25 * observedOrder(mean(0.016), mean(0.001));
        QVERIFY2(std::abs(observed - 1.0) < 0.15, qPrintable(QString::number(observed)));
        QVERIFY(errorOf(Naive, 0.0013) > 1e-5);
        QVERIFY(errorOf(Rk4Located, 0.0013) < 1e-13); // parabolas: exact
    }

    void denseOutputHasOrderFour()
    {
        std::array<double, 2> error{};
        for (std::size_t i = 0; i < 2; ++i) {
            Log log;
            for (int k = 1; k < 300; ++k) log.askedTimes.push_back(0.0333 * k);
            integrate(Rk4Located, smooth, {1.0, 0.0}, 10.0, 0.1 / double(1 << i), log);
            for (std::size_t k = 0; k < log.dense.size(); ++k)
                error[i] = std::max(error[i], std::abs(log.dense[k][0] -
                                                       System::exact(smooth.upper, {1.0, 0.0}, log.askedTimes[k])[0]));
        }
        QVERIFY2(std::abs(observedOrder(error[0], error[1]) - 4.0) < 0.3,
                 qPrintable(QString::number(observedOrder(error[0], error[1]))));
    }

    void stepsEndOnTheGrid_data() { methodRows(); }
    void stepsEndOnTheGrid()
    {
        QFETCH(int, method);
        Log log;
        const auto result = integrate(Method(method), bilinear, {1.0, 0.0}, 10.0, 0.03, log);
        QCOMPARE(result.steps, 334LL);
        QCOMPARE(log.times.back(), 10.0);
        for (int i = 1; i <= 333; ++i)
            QVERIFY(std::find(log.times.begin(), log.times.end(), i * 0.03) != log.times.end());
    }

    /// The largest step of rk4 on the imaginary axis is 2.83/omega (numerics of Hairer & Wanner II, IV.2).
    void rk4IsUnstableBeyondItsLimit()
    {
        const PiecewiseOscillator oscillator = smoothOscillator({0.0, 1.0, 0.0});
        Log stable, unstable;
        integrate(Rk4Located, oscillator, {1.0, 0.0}, 2800.0, 2.8, stable);
        QVERIFY(stable.last().norm() < 1.0);
        integrate(Rk4Located, oscillator, {1.0, 0.0}, 2900.0, 2.9, unstable);
        QVERIFY(unstable.last().norm() > 1e3);
    }
    /// Average acceleration conserves the energy of a linear oscillator for any step.
    void newmarkIsStableForAnyStep()
    {
        const PiecewiseOscillator oscillator = smoothOscillator({0.0, 1.0, 0.0});
        Log log;
        integrate(NewmarkLocated, oscillator, {1.0, 0.0}, 1e5, 100.0, log);
        QVERIFY(std::abs(log.last().norm() - 1.0) < 1e-9);
    }

    void blowUpEnds_data() { methodRows(); }
    void blowUpEnds()
    {
        QFETCH(int, method);
        const PiecewiseOscillator unstable = smoothOscillator({0.0, -1e6, 0.0});
        Log log;
        const auto result = integrate(Method(method), unstable, {1.0, 0.0}, 10.0, 1e-3, log);
        QVERIFY(result.end == IntegrationEnd::Diverged || result.end == IntegrationEnd::NewtonFailed);
        QVERIFY(log.last().allFinite());
    }

    /// At 1e6 a second after a second of flight the boundary can be met to 1e-10 only, far more than the round-off of q
    /// = 0: still one switch, whichever side of the boundary the step ends on.
    void aFastCrossingIsOneSwitch()
    {
        const PiecewiseOscillator flight = switchedOscillator({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
        for (int i = 0; i < 100; ++i) {
            Log log;
            const double height = 1e6 * (1.0 + 0.0037 * i);
            QCOMPARE(integrate(Rk4Located, flight, {height, -1e6}, 2.0, 0.7, log).end, IntegrationEnd::Reached);
            QCOMPARE(log.events.size(), std::size_t{1});
            QVERIFY(std::abs(log.events[0].time - height / 1e6) < 1e-14);
        }
    }

    void chatteringEnds()
    {
        const PiecewiseOscillator sliding = switchedOscillator({-1.0, 0.0, 2.0}, {1.0, 0.0, 2.0});
        Log log;
        QCOMPARE(integrate(Rk4Located, sliding, {0.1, 0.0}, 100.0, 0.01, log).end, IntegrationEnd::Chattering);
    }

    /// A wall that pushes with -1e4 q below zero cannot be crossed with little energy; a step of 3 jumps it.
    void aJumpedWallIsReported_data()
    {
        QTest::addColumn<int>("method");
        QTest::newRow("rk4") << int(Naive);
        QTest::newRow("rk4-events") << int(Rk4Located);
    }
    void aJumpedWallIsReported()
    {
        QFETCH(int, method);
        // Above the switch the force is a steep repulsion that grows towards it; crossing costs 0.5 * 400 * 1^2 = 200,
        // the slider has 0.5.
        const PiecewiseOscillator hill = switchedOscillator({400.0, 400.0, 0.0}, {400.0, 400.0, 0.0}, true);
        Log log;
        const auto result = integrate(Method(method), hill, {1.5, -1.0}, 10.0, 0.4, log);
        QCOMPARE(result.end, IntegrationEnd::Tunnelled);
        Log fine;
        QCOMPARE(integrate(Method(method), hill, {1.5, -1.0}, 10.0, 0.001, fine).end, IntegrationEnd::Reached);
        QCOMPARE(fine.events.size(), std::size_t{0});
    }

    void stepsAllocateNothing_data() { methodRows(); }
    void stepsAllocateNothing()
    {
        QFETCH(int, method);
        EventCount recorder;
        const long long before = allocations;
        const auto result = integrate(Method(method), bilinear, {1.0, 0.0}, 1000.0, 0.01, recorder);
        QCOMPARE(allocations - before, 0LL);
        QVERIFY(result.steps == 100000 && recorder.events > 100);
    }
};

TOUCHDOWN_TEST(TestFixedStep)

} // namespace test_fixed_step

#include "test_fixed_step.moc"
