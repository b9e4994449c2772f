// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/backward_difference.h"

#include <array>
#include <cmath>
#include <complex>
#include <random>

#include <QtTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_backward_difference {

using Complex = std::complex<double>;

constexpr double rate = 2e6; // [rad/s]

/// Steps of about this phase that change by up to a fifth from one to the next, from the last one back.
std::array<double, 4> unequalSteps(std::mt19937_64& random, double phase)
{
    std::uniform_real_distribution<double> change(1.0 / 1.2, 1.2);
    std::array<double, 4> steps{phase / rate};
    for (std::size_t k = 1; k < steps.size(); ++k) steps[k] = steps[k - 1] * change(random);
    return steps;
}

/// The formula's derivative of f at zero, the end of the step.
template <typename F>
auto derivative(const BackwardDifference& d, const std::array<double, 4>& h, const F& f)
{
    return d.perTime * f(0.0) - d.share[0] * f(-h[0]) - d.share[1] * f(-h[0] - h[1]) -
           d.share[2] * f(-h[0] - h[1] - h[2]);
}
template <typename F>
auto forecast(const std::array<double, 4>& w, const std::array<double, 4>& h, const F& f)
{
    return w[0] * f(-h[0]) + w[1] * f(-h[0] - h[1]) + w[2] * f(-h[0] - h[1] - h[2]) +
           w[3] * f(-h[0] - h[1] - h[2] - h[3]);
}
Complex wave(double t, double omega = rate) { return std::polar(1.0, omega * t); }

bool isBdf2Opt(double dt, double h1, double h2, double omega)
{
    const BackwardDifference a = backwardDifference(BackwardRule::Fitted, dt, h1, h2, omega),
                             b = backwardDifference(BackwardRule::Bdf2Opt, dt, h1, h2);
    return a.perTime == b.perTime && a.share == b.share && a.taken == b.taken;
}

class TestBackwardDifference : public QObject {
    Q_OBJECT

private slots:
    /// 1, t, cos and sin of the rate, whatever the steps.
    void fittedIsExact()
    {
        std::mt19937_64 random(7);
        for (const double phase : {0.03, 0.1, 0.3, 0.6, 1.0})
            for (int k = 0; k < 50; ++k) {
                const std::array<double, 4> h = unequalSteps(random, phase);
                const BackwardDifference d = backwardDifference(BackwardRule::Fitted, h[0], h[1], h[2], rate);
                const double scale = d.perTime;
                QVERIFY(std::abs(derivative(d, h, [](double) { return 1.0; })) < 1e-9 * scale);
                QVERIFY(std::abs(derivative(d, h, [](double t) { return t; }) - 1.0) < 1e-9);
                QVERIFY(std::abs(derivative(d, h, [](double t) { return wave(t); }) - Complex(0.0, rate)) <
                        1e-9 * scale);
                const auto w = fittedForecast(h[0], h[1], h[2], h[3], rate);
                QVERIFY(w);
                QVERIFY(std::abs(forecast(*w, h, [](double) { return 1.0; }) - 1.0) < 1e-9);
                QVERIFY(std::abs(forecast(*w, h, [](double t) { return t; })) < 1e-9 * h[0]);
                QVERIFY(std::abs(forecast(*w, h, [](double t) { return wave(t); }) - 1.0) < 1e-9);
            }
    }
    /// Short steps: BDF3 and the cubic through the last values.
    void fittedTendsToBdf3()
    {
        const double h = 0.021 / rate;
        const BackwardDifference d = backwardDifference(BackwardRule::Fitted, h, h, h, rate);
        QVERIFY(std::abs(d.perTime * h - 11.0 / 6.0) < 1e-3);
        for (std::size_t k = 0; k < 3; ++k)
            QVERIFY(std::abs(d.share[k] * h - std::array{3.0, -1.5, 1.0 / 3.0}[k]) < 1e-3);
        const auto w = fittedForecast(h, h, h, h, rate);
        QVERIFY(w);
        for (std::size_t k = 0; k < 4; ++k) QVERIFY(std::abs((*w)[k] - std::array{4.0, -6.0, 4.0, -1.0}[k]) < 1e-3);
    }
    /// Other oscillations, of x = omega h: the relative error -i x (x0^2 - x^2)/4; BDF2OPT has (1 - 0.48)/3 x^2.
    void errorAtOtherRates()
    {
        const double x0 = 0.2, h = x0 / rate;
        const BackwardDifference d = backwardDifference(BackwardRule::Fitted, h, h, h, rate);
        const std::array<double, 4> steps{h, h, h, h};
        for (const double share : {0.25, 0.5, 0.75, 1.2}) {
            const double x = share * x0, omega = share * rate;
            const Complex found = derivative(d, steps, [omega](double t) { return wave(t, omega); });
            const Complex error = found / Complex(0.0, omega) - 1.0, expected(0.0, -0.25 * x * (x0 * x0 - x * x));
            QVERIFY2(std::abs(error - expected) < 0.3 * std::abs(expected),
                     qPrintable(QString("%1 %2").arg(std::abs(error)).arg(std::abs(expected))));
        }
    }
    void fallsBackToBdf2Opt()
    {
        const double h = 0.5 / rate;
        QVERIFY(!isBdf2Opt(h, h, h, rate));
        QVERIFY(!isBdf2Opt(h, 1.2 * h, h, rate) && !isBdf2Opt(h, h, h / 1.2, rate));
        QVERIFY(isBdf2Opt(h, h, h, 0.0)); // unknown
        QVERIFY(isBdf2Opt(h, 0.0, 0.0, rate) && isBdf2Opt(h, h, 0.0, rate));
        QVERIFY(isBdf2Opt(h, 0.7 * h, h, rate) && isBdf2Opt(h, h, 1.4 * h, rate) && isBdf2Opt(0.7 * h, h, h, rate));
        QVERIFY(isBdf2Opt(h, h, h, 0.019 / h) && !isBdf2Opt(h, h, h, 0.021 / h));
        QVERIFY(isBdf2Opt(h, h, h, 1.31 / h) && !isBdf2Opt(h, h, h, 1.29 / h));
        QVERIFY(!fittedForecast(h, h, h, 0.0, rate) && !fittedForecast(h, h, h, 1.4 * h, rate));
        QVERIFY(fittedForecast(h, h, h, h, rate));
        const auto fitted = [](double dt, double h1, double h2, double omega) {
            return backwardDifference(BackwardRule::Fitted, dt, h1, h2, omega).fitted;
        };
        QVERIFY(!fitted(h, h, 1.4 * h, rate) && !fitted(h, h, h, 1.31 / h));
        QVERIFY(fitted(h, h, h, rate));
    }
    /// Steps that change at random within what is fitted, on y' = lambda y at 40 degrees and more from the imaginary
    /// axis, from the slowest to the fastest: what is there fades.
    void decaysWithUnequalSteps()
    {
        std::mt19937_64 random(11);
        for (const double size : {0.1, 0.5, 2.0, 10.0, 1e4})
            for (const double angle : {0.0, 0.5, -0.5, 0.85}) {
                std::array<Complex, 3> y{1.0, -1.0, 1.0};
                std::array<double, 3> h{0.6 / rate, 0.6 / rate, 0.6 / rate};
                const Complex lambda = -size / h[0] * std::polar(1.0, angle);
                std::uniform_real_distribution<double> change(0.0, 1.0);
                double largest = 0.0;
                for (int n = 0; n < 400; ++n) {
                    const double lowest = std::max(0.3 / rate, h[0] / 1.24),
                                 highest = std::min(1.2 / rate, h[0] * 1.24);
                    const double dt = lowest + change(random) * (highest - lowest);
                    const BackwardDifference d = backwardDifference(BackwardRule::Fitted, dt, h[0], h[1], rate);
                    y = {(d.share[0] * y[0] + d.share[1] * y[1] + d.share[2] * y[2]) / (d.perTime - lambda), y[0],
                         y[1]};
                    h = {dt, h[0], h[1]};
                    largest = std::max(largest, std::abs(y[0]));
                }
                QVERIFY2(largest < 5.0 && std::abs(y[0]) < 1e-6,
                         qPrintable(QString("%1 %2: %3 %4").arg(size).arg(angle).arg(largest).arg(std::abs(y[0]))));
            }
    }
};

TOUCHDOWN_TEST(TestBackwardDifference)

} // namespace test_backward_difference

#include "test_backward_difference.moc"
