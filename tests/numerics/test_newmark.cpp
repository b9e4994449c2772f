// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/newmark.h"

#include <QTest>

#include "tests/support/piecewise_oscillator.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_newmark {

/// q" = -q^3: nonlinear, so that Newton's iteration has work to do.
struct Cubic : PiecewiseOscillator {
    State derivative(const State& y, Mode) const { return {y[1], -y[0] * y[0] * y[0]}; }
    State naiveDerivative(const State& y, Mode mode) const { return derivative(y, mode); }
    Eigen::Matrix<double, 1, 2> jacobian(const State& y, Mode) const { return {-3.0 * y[0] * y[0], 0.0}; }
};

class TestNewmark : public QObject {
    Q_OBJECT

private slots:
    /// The exact discrete answer for q" = -q: with x = h^2/4, q1 = [(1 - x) q0 + h v0]/(1 + x), v1 = [(1 - x) v0 - h
    /// q0]/(1 + x).
    void oneLinearStep()
    {
        const PiecewiseOscillator oscillator = smoothOscillator({0.0, 1.0, 0.0});
        NewmarkStepper<PiecewiseOscillator> stepper(oscillator, {});
        PiecewiseOscillator::State y1;
        QVERIFY(stepper.step({0.7, -0.2}, PiecewiseOscillator::Mode::Upper, 0.8, y1));
        const double x = 0.16;
        QVERIFY(std::abs(y1[0] - ((1.0 - x) * 0.7 - 0.8 * 0.2) / (1.0 + x)) < 1e-15);
        QVERIFY(std::abs(y1[1] - ((1.0 - x) * -0.2 - 0.8 * 0.7) / (1.0 + x)) < 1e-15);
    }
    /// Newton's iteration with the right derivatives solves a linear step at once: a0, the residual, and the look that
    /// it is zero.
    void aLinearStepTakesOneIteration()
    {
        const PiecewiseOscillator oscillator = smoothOscillator({0.3, 1.0, 2.0});
        NewmarkStepper<PiecewiseOscillator> stepper(oscillator, {});
        PiecewiseOscillator::State y1;
        QVERIFY(stepper.step({0.7, -0.2}, PiecewiseOscillator::Mode::Upper, 0.8, y1));
        QCOMPARE(stepper.evaluations, 3LL);
    }
    /// A nonlinear step satisfies Newmark's equations and the equation of motion at its end.
    void oneNonlinearStep()
    {
        const Cubic cubic;
        NewmarkStepper<Cubic> stepper(cubic, {});
        const Cubic::State y0{1.2, 0.5};
        const double h = 0.4;
        Cubic::State y1;
        QVERIFY(stepper.step(y0, Cubic::Mode::Upper, h, y1));
        const double a0 = -y0[0] * y0[0] * y0[0];
        const double a1 = -y1[0] * y1[0] * y1[0];
        QVERIFY(std::abs(y1[0] - (y0[0] + h * y0[1] + h * h / 4.0 * (a0 + a1))) < 1e-13);
        QVERIFY(std::abs(y1[1] - (y0[1] + h / 2.0 * (a0 + a1))) < 1e-13);
    }
    void noSolutionIsSaid()
    {
        // q" = 1 + q^2 with a step so long that the equation of the step has no root.
        struct Runaway : PiecewiseOscillator {
            State derivative(const State& y, Mode) const { return {y[1], 1.0 + y[0] * y[0]}; }
            State naiveDerivative(const State& y, Mode mode) const { return derivative(y, mode); }
            Eigen::Matrix<double, 1, 2> jacobian(const State& y, Mode) const { return {2.0 * y[0], 0.0}; }
        };
        const Runaway runaway;
        NewmarkStepper<Runaway> stepper(runaway, {});
        Runaway::State y1;
        QVERIFY(!stepper.step({1.0, 1.0}, Runaway::Mode::Upper, 10.0, y1));
    }
};

TOUCHDOWN_TEST(TestNewmark)

} // namespace test_newmark

#include "test_newmark.moc"
