// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/stability_region.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_stability_region {

using Complex = std::complex<double>;

/// Up to which h the method is stable for lambda of size 1 in this direction.
double limit(const Growth& growth, Complex direction, double to = 100.0)
{
    return largestStable([&](double h) { return growth(h * direction) <= stableGrowth; }, 1e-3, to);
}
double coupledLimit(const CoupledRule& rule, double dampingRatio, double leak)
{
    return largestStable([&](double w) { return coupledGrowth(rule, w, dampingRatio, leak) <= stableGrowth; }, 1e-4,
                         20.0);
}

#define NEAR(value, expected, tolerance)                                                                               \
    QVERIFY2(std::abs((value) - (expected)) <= (tolerance), qPrintable(QString::number((value), 'g', 12)))

class TestStabilityRegion : public QObject {
    Q_OBJECT

private slots:
    /// 1 + z + z^2/2 + z^3/6 + z^4/24; on the imaginary axis |R|^2 = 1 - y^6/72 + y^8/576, so that y = sqrt 8 is the
    /// end.
    void classicalRungeKutta()
    {
        for (const Complex z : {Complex(-1.0, 0.5), Complex(0.3, 2.0), Complex(-3.0, -1.0)})
            NEAR(rk4Growth(z), std::abs(1.0 + z + z * z / 2.0 + z * z * z / 6.0 + z * z * z * z / 24.0), 1e-14);
        NEAR(limit(rk4Growth, {0.0, 1.0}), std::sqrt(8.0), 1e-8);
        // On the negative real axis z (24 + 12 z + 4 z^2 + z^3) = 0.
        NEAR(limit(rk4Growth, {-1.0, 0.0}), 2.785293563405282, 1e-8);
    }
    /// Order 5 and six stages: z^6/600 besides the exponential's first six terms. With x = y^2 on the imaginary axis
    /// |R|^2 - 1 = x^3/14400 (-8 + 9 x - x^2 + x^3/25).
    void dormandPrince()
    {
        for (const Complex z : {Complex(-1.0, 0.5), Complex(0.3, 2.0), Complex(-3.0, -1.0)}) {
            Complex sum = 1.0, power = 1.0;
            for (int k = 1; k <= 5; ++k) sum += power *= z / double(k);
            NEAR(dopri5Growth(z), std::abs(sum + std::pow(z, 6) / 600.0), 1e-13);
        }
        NEAR(limit(dopri5Growth, {-1.0, 0.0}), 3.306567892634947, 1e-8);
        // Growth sets in so slowly that what stableGrowth leaves for round-off counts.
        const double x = std::pow(limit(dopri5Growth, {0.0, 1.0}), 2), left = stableGrowth * stableGrowth - 1.0;
        NEAR(-8.0 + 9.0 * x - x * x + x * x * x / 25.0, left * 14400.0 / (x * x * x), 1e-9);
    }
    /// Newmark with gamma 1/2 is stable up to omega h = 2/sqrt(1 - 4 beta) without damping: explicit 2, Fox and Goodwin
    /// sqrt 6, the trapezoidal rule always. Its eigenvalues: cos phi = 1 - w^2/2/(1 + beta w^2).
    void newmark_data()
    {
        QTest::addColumn<double>("beta");
        QTest::newRow("explicit") << 0.0;
        QTest::newRow("Fox and Goodwin") << 1.0 / 12;
        QTest::newRow("linear acceleration") << 1.0 / 6;
        QTest::newRow("beta 0.24") << 0.24;
    }
    void newmark()
    {
        QFETCH(double, beta);
        const auto growth = [&](Complex z) { return newmarkGrowth(beta, 0.5, z); };
        const double end = 2.0 / std::sqrt(1.0 - 4.0 * beta);
        // Two eigenvalues meet there, so that round-off is of the size of its root.
        NEAR(limit(growth, {0.0, 1.0}), end, 1e-6 * end);
        const double w = 1.5 * end, c = 1.0 - 0.5 * w * w / (1.0 + beta * w * w);
        NEAR(growth({0.0, w}), -c + std::sqrt(c * c - 1.0), 1e-10 * growth({0.0, w}));
    }
    void trapezoidal()
    {
        for (const double h : {0.1, 2.0, 50.0}) {
            NEAR(newmarkGrowth(0.25, 0.5, {0.0, h}), 1.0, 1e-12);
            QVERIFY(newmarkGrowth(0.25, 0.5, h * std::polar(1.0, 0.6 * std::numbers::pi)) < 1.0);
        }
        // gamma above 1/2 damps, below it blows up.
        QVERIFY(newmarkGrowth(0.3025, 0.6, {0.0, 1.0}) < 1.0 && newmarkGrowth(0.25, 0.4, {0.0, 1.0}) > 1.0);
    }
    /// Euler 1/|1 - z|. BDF2: (3/2 - z) x^2 - 2 x + 1/2 = 0. BDF2OPT besides 0.48 (x^3 - 3 x^2 + 3 x - 1)/3.
    void backwardDifferences()
    {
        for (const Complex z : {Complex(-1.0, 0.5), Complex(0.3, 2.0), Complex(-30.0, -1.0)}) {
            NEAR(backwardGrowth(BackwardRule::Euler, z), 1.0 / std::abs(1.0 - z), 1e-14);
            const Complex root = std::sqrt(4.0 - 2.0 * (1.5 - z));
            const double larger = std::max(std::abs(2.0 + root), std::abs(2.0 - root)) / std::abs(2.0 * (1.5 - z));
            NEAR(backwardGrowth(BackwardRule::Bdf2, z), larger, 1e-13);
        }
        const double x = backwardGrowth(BackwardRule::Bdf2Opt, -0.2);
        NEAR((1.5 + 0.2) * x * x * x - 2.0 * x * x + 0.5 * x + 0.16 * std::pow(x - 1.0, 3), 0.0, 1e-14);
    }
    /// All three damp the whole left half of the plane, and all the more the farther out (L-stable). Slow oscillations:
    /// with D = 1 - exp(-iy), BDF2 misses D^3/3 + D^4/4 + ..., whose real part is -y^4/2 + y^4/4: it damps by y^4/4 a
    /// step; with a share t of D^3/3, BDF2OPT damps by (1 - t)/2 - 1/4, 0.04 of that. Euler by y^2/2.
    void backwardDifferencesAreLStable()
    {
        using enum BackwardRule;
        for (const BackwardRule rule : {Euler, Bdf2, Bdf2Opt}) {
            for (double angle = 0.5; angle <= 1.5; angle += 0.01)
                for (double size = 0.01; size < 1e4; size *= 1.3)
                    QVERIFY(backwardGrowth(rule, size * std::polar(1.0, angle * std::numbers::pi)) <= 1.0 + 1e-12);
            QVERIFY(backwardGrowth(rule, -1e8) < 0.01);
        }
        const double y = 0.05;
        NEAR((1.0 - backwardGrowth(Euler, {0.0, y})) / (y * y / 2.0), 1.0, 0.01);
        NEAR((1.0 - backwardGrowth(Bdf2, {0.0, y})) / (std::pow(y, 4) / 4.0), 1.0, 0.02);
        const double share = (1.0 - backwardGrowth(Bdf2Opt, {0.0, y})) / (1.0 - backwardGrowth(Bdf2, {0.0, y}));
        NEAR(share, 1.0 - 2.0 * 0.48, 2.0 * y * y);
    }

    /// The fitted formula takes a wave of its own phase as it is, damps all whose damping ratio is above 0.07 and lets
    /// the others grow by less than 4.5 % a step; those that it lets grow are faster than its own.
    void fittedBackwardDifference()
    {
        for (double phase = 0.3; phase < 1.05; phase += 0.1) {
            NEAR(backwardGrowth(BackwardRule::Fitted, {0.0, phase}, phase), 1.0, 1e-12);
            for (double size = 0.01; size < 1e4; size *= 1.1) {
                const double undamped = backwardGrowth(BackwardRule::Fitted, {0.0, size}, phase);
                QVERIFY2(undamped < (size < phase ? 1.0 + 1e-12 : 1.045), qPrintable(QString::number(undamped)));
                for (double damping = 0.07; damping <= 1.0; damping += 0.03)
                    QVERIFY(backwardGrowth(BackwardRule::Fitted,
                                           size * Complex(-damping, std::sqrt(1.0 - damping * damping)), phase) < 1.0);
            }
        }
        QVERIFY(backwardGrowth(BackwardRule::Fitted, -1e8, 0.6) < 0.01);
        QVERIFY(backwardGrowth(BackwardRule::Fitted, {0.0, 1.2}, 0.6) > 1.02);
    }

    /// Without a leak the film is a spring: Newmark's own limits. With one, the monolithic step stays stable.
    void monolithicCoupling()
    {
        const CoupledRule fox{.beta = 1.0 / 12}, trapezoidal{.beta = 0.25};
        NEAR(coupledLimit(fox, 0.0, 0.0), std::sqrt(6.0), 1e-5);
        for (const double leak : {0.0, 0.001, 0.02, 1.0, 30.0}) QCOMPARE(coupledLimit(trapezoidal, 0.0, leak), 20.0);
    }
    /// In turns until they agree: to beta w^2 = 1 + zeta w at most, w = 2 zeta + 2 sqrt(1 + zeta^2) for the trapezoidal
    /// rule without leak; as coupledGrowth says by being infinite. A leak of the size of the film's own rate moves it
    /// further.
    void iteratedCoupling()
    {
        const CoupledRule iterated{.coupling = CouplingKind::Iterated};
        for (const double zeta : {0.0, 0.01, 0.05})
            NEAR(coupledLimit(iterated, zeta, 0.0), 2.0 * zeta + 2.0 * std::sqrt(1.0 + zeta * zeta), 1e-6);
        QVERIFY(std::isinf(coupledGrowth(iterated, 2.1, 0.0, 0.0)));
        QVERIFY(coupledLimit(iterated, 0.0, 1.0) > 2.2);
    }
    /// One-way: the force of the last time, h old, works like a negative dashpot of k h, so that 2 zeta omega M < k h
    /// blows up: w = 2 zeta while that is small. One turn more and the limit is about that of the iteration, two more
    /// and it is lower again.
    void oneWayCoupling()
    {
        const double leak = 1e-3;
        for (const double zeta : {0.002, 0.01, 0.05}) {
            CoupledRule rule{.film = BackwardRule::Euler, .coupling = CouplingKind::InTurns};
            const double oneWay = coupledLimit(rule, zeta, leak);
            QVERIFY2(oneWay > 1.9 * zeta && oneWay < 2.7 * zeta, qPrintable(QString::number(oneWay)));
            rule.turns = 2;
            QVERIFY2(coupledLimit(rule, zeta, leak) > 1.9, qPrintable(QString::number(coupledLimit(rule, zeta, leak))));
            rule.turns = 3;
            QVERIFY2(coupledLimit(rule, zeta, leak) < 1.3, qPrintable(QString::number(coupledLimit(rule, zeta, leak))));
        }
        // A film that leaks at once is a dashpot k/s: harmless.
        const CoupledRule rule{.film = BackwardRule::Euler, .coupling = CouplingKind::InTurns};
        QVERIFY(coupledLimit(rule, 0.002, 10.0) > 1.0);
    }

    /// Of rk4 one closed line in both halves of the plane, through both ends of the real axis; growth is 1 all along.
    void boundary()
    {
        const auto lines = stabilityBoundary(rk4Growth, {.left = -4.0, .right = 1.0, .height = 4.0, .columns = 100});
        QCOMPARE(lines.size(), std::size_t{1});
        QVERIFY(std::abs(lines[0].front() - lines[0].back()) < 1e-7);
        double lowest = 0.0, highest = 0.0, left = 0.0;
        for (const Complex z : lines[0]) {
            NEAR(rk4Growth(z), 1.0, 1e-7);
            lowest = std::min(lowest, z.imag());
            highest = std::max(highest, z.imag());
            left = std::min(left, z.real());
        }
        NEAR(left, -2.785293563405282, 1e-6);
        QVERIFY(highest > 2.9 && std::abs(highest + lowest) < 1e-12);
        // The trapezoidal rule: the imaginary axis, from one end of the window to the other.
        const auto axis = stabilityBoundary([](Complex z) { return newmarkGrowth(0.25, 0.5, z); },
                                            {.left = -3.9, .right = 1.0, .height = 4.0, .columns = 60});
        QCOMPARE(axis.size(), std::size_t{1});
        for (const Complex z : axis[0]) QVERIFY(std::abs(z.real()) < 1e-6);
        QVERIFY(std::abs(axis[0].front() - std::conj(axis[0].back())) < 1e-6 && std::abs(axis[0].front().imag()) > 3.9);
    }
};

TOUCHDOWN_TEST(TestStabilityRegion)

} // namespace test_stability_region

#include "test_stability_region.moc"
