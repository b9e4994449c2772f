// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/events.h"

#include <random>

#include <QTest>

#include "tests/support/piecewise_oscillator.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_events {

using Coefficients = std::array<double, 5>;

double value(const Coefficients& c, double x)
{
    const double w = 1.0 - x;
    return w * w * w * w * c[0] + 4 * w * w * w * x * c[1] + 6 * w * w * x * x * c[2] + 4 * w * x * x * x * c[3] +
           x * x * x * x * c[4];
}

/// Bernstein coefficients of a + b x + c x^2: b_k = a + b k/4 + c k(k-1)/12.
Coefficients quadratic(double a, double b, double c)
{
    Coefficients out;
    for (std::size_t k = 0; k < 5; ++k) out[k] = a + b * double(k) / 4.0 + c * double(k) * (double(k) - 1.0) / 12.0;
    return out;
}

class TestEvents : public QObject {
    Q_OBJECT

private slots:
    void firstDescent_data()
    {
        QTest::addColumn<double>("a");
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("c");
        QTest::addColumn<double>("expected"); // negative: none
        QTest::newRow("straight down through 0.25") << 0.25 << -1.0 << 0.0 << 0.25;
        QTest::newRow("straight up never descends") << 0.25 << 1.0 << 0.0 << -1.0;
        // (x - 0.3)(x - 0.31): both ends are inside, a look at the ends alone would miss it.
        QTest::newRow("dips below for a hundredth of the step") << 0.093 << -0.61 << 1.0 << 0.3;
        // (x - 0.5)^2 + 1e-6 and - 1e-12.
        QTest::newRow("passes by at a millionth") << 0.250001 << -1.0 << 1.0 << -1.0;
        QTest::newRow("grazes by 1e-12") << 0.25 - 1e-12 << -1.0 << 1.0 << 0.5 - 1e-6;
        QTest::newRow("starts on the boundary and moves in") << 0.0 << 1.0 << 0.0 << -1.0;
        QTest::newRow("starts on the boundary, in and out again") << 0.0 << 1.0 << -2.0 << 0.5;
        QTest::newRow("starts outside") << -1.0 << 4.0 << 0.0 << 0.0;
        QTest::newRow("descends at the very end") << 1.0 << -1.0 - 1e-9 << 0.0 << 1.0 - 1e-9;
    }
    void firstDescent()
    {
        QFETCH(double, a);
        QFETCH(double, b);
        QFETCH(double, c);
        QFETCH(double, expected);
        const std::optional<double> at = touchdown::firstDescent(quadratic(a, b, c));
        QCOMPARE(at.has_value(), expected >= 0.0);
        if (at) QVERIFY2(std::abs(*at - expected) < 1e-10, qPrintable(QString::number(*at, 'g', 17)));
    }

    /// Against 20 000 samples of each of 2000 random quartics.
    void agreesWithSampling()
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> uniform(-1.0, 1.0);
        int crossings = 0;
        for (int i = 0; i < 2000; ++i) {
            Coefficients c;
            for (double& x : c) x = uniform(random);
            c[0] = std::abs(c[0]);
            double sampled = -1.0;
            for (int k = 1; k <= 20000 && sampled < 0.0; ++k)
                if (value(c, k / 20000.0) < 0.0) sampled = k / 20000.0;
            const std::optional<double> at = touchdown::firstDescent(c);
            if (sampled < 0.0) {
                // Sampling may miss a short dip; then the polynomial must really be negative just behind the place
                // found.
                if (at) QVERIFY(value(c, *at + 1e-9) <= 0.0);
                continue;
            }
            ++crossings;
            QVERIFY(at.has_value());
            QVERIFY(*at <= sampled);
            QVERIFY(std::abs(value(c, *at)) < 1e-12);
        }
        QVERIFY(crossings > 500);
    }

    void chatterIsManySwitchesInOnePeriod()
    {
        ChatterWatch slow;
        for (int i = 0; i < 1000; ++i) QVERIFY(!slow.tooMany(i * 0.1, 1.0)); // ten in a period
        ChatterWatch fast;
        int switches = 0;
        while (!fast.tooMany(switches * 0.001, 1.0) && switches < 1000) ++switches;
        QCOMPARE(switches, 64); // the 65th within one period
    }

    /// A step ends on the boundary to round-off: fall from rest at h = 1 under g = 2 takes exactly 1 s.
    void stepEndsOnCrossing()
    {
        const PiecewiseOscillator fall = switchedOscillator({-2.0, 0.0, 0.0}, {-2.0, 0.0, 0.0});
        const GuardWatch<PiecewiseOscillator> watch(fall, PiecewiseOscillator::Mode::Upper);
        const auto take = [](double h) { return PiecewiseOscillator::State(1.0 - h * h, -2.0 * h); };
        double length = 0.97; // as from an inaccurate dense output
        bool crossed = false;
        const auto y = endOnCrossing(watch, Crossing{0.97 / 1.5, 0, false}, 0.0, 1.5, length, crossed, take);
        QVERIFY(crossed);
        QVERIFY(std::abs(length - 1.0) < 1e-15);
        QVERIFY(std::abs(y[0]) < 1e-14);
    }

    /// The dense output saw a crossing that the step, taken anew, does not make.
    void aGrazeFromInsideIsNoCrossing()
    {
        const PiecewiseOscillator system;
        const GuardWatch<PiecewiseOscillator> watch(system, PiecewiseOscillator::Mode::Upper);
        const auto take = [](double h) {
            return PiecewiseOscillator::State(1e-6 + (h - 0.5) * (h - 0.5), 2.0 * (h - 0.5));
        };
        double length = 0.49;
        bool crossed = true;
        const auto y = endOnCrossing(watch, Crossing{0.49, 0, false}, 0.0, 1.0, length, crossed, take);
        QVERIFY(!crossed);
        QVERIFY(y[0] > 0.0);
        QVERIFY(length > 0.0 && length <= 1.0);
    }

    void twoEndsOfOneInterval()
    {
        const PiecewiseOscillator system;
        GuardWatch<PiecewiseOscillator> watch(system, PiecewiseOscillator::Mode::Upper);
        std::array<PiecewiseOscillator::State, 5> down;
        const Coefficients c = quadratic(0.5, -1.0, 0.0);
        for (std::size_t k = 0; k < 5; ++k) down[k] = {c[k], -1.0};
        const std::optional<Crossing> lower = watch.first(down, 0.0);
        QVERIFY(lower && !lower->upper && std::abs(lower->at - 0.5) < 1e-15);
        watch.enter(PiecewiseOscillator::Mode::Lower); // now q must stay below 0: the step starts outside
        const std::optional<Crossing> upper = watch.first(down, 0.0);
        QVERIFY(upper && upper->upper && upper->at == 0.0);
    }
};

TOUCHDOWN_TEST(TestEvents)

} // namespace test_events

#include "test_events.moc"
