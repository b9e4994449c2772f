// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newmark's method (Newmark 1959), with Newton's iteration for the acceleration at the end of the step:
//
//   q1 = q0 + h v0 + h^2 [ (1/2 - beta) a0 + beta a1 ],   v1 = v0 + h [ (1 - gamma) a0 + gamma a1 ],
//   a1 = a(q1, v1)
//
// Order 2 for gamma = 1/2, else 1. beta = 1/4, gamma = 1/2: the average acceleration, unconditionally stable for
// linear systems. The system has derivative(y, mode), scale() and jacobian(y, mode), the derivatives of the
// acceleration by the state.
#pragma once

#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "core/numerics/switched_system.h"

namespace touchdown {

struct NewmarkOptions {
    double beta = 0.25; // [-]
    double gamma = 0.5; // [-]
    int mostIterations = 25;
};

template <class System>
class NewmarkStepper {
public:
    using State = typename System::State;
    static constexpr int half = State::RowsAtCompileTime / 2;
    using Vector = Eigen::Matrix<double, half, 1>;
    using Square = Eigen::Matrix<double, half, half>;
    static constexpr IntegrationEnd failure = IntegrationEnd::NewtonFailed;

    NewmarkStepper(const System& system, const NewmarkOptions& options) : system_(system), options_(options) {}

    /// False when Newton's iteration does not converge; y1 is then not to be used.
    bool step(const State& y, typename System::Mode mode, double h, State& y1)
    {
        const double beta = options_.beta;
        const double gamma = options_.gamma;
        const Vector a0 = acceleration(y, mode);
        const State scale = system_.scale();
        Vector a1 = a0;
        double previous = std::numeric_limits<double>::infinity();
        const auto setEnd = [&] {
            y1.template head<half>() =
                y.template head<half>() + h * y.template tail<half>() + h * h * ((0.5 - beta) * a0 + beta * a1);
            y1.template tail<half>() = y.template tail<half>() + h * ((1.0 - gamma) * a0 + gamma * a1);
        };
        for (int i = 0; i < options_.mostIterations; ++i) {
            setEnd();
            const Vector residual = a1 - acceleration(y1, mode);
            const auto j = system_.jacobian(y1, mode);
            const Square newton = Square::Identity() - beta * h * h * j.template leftCols<half>() -
                                  gamma * h * j.template rightCols<half>();
            const Vector change = newton.inverse() * residual;
            a1 -= change;
            // The residual is quadratic in the change: stop where it moves the state by less than round-off.
            const double moved = (gamma * h * change).cwiseQuotient(scale.template tail<half>()).cwiseAbs().maxCoeff();
            if (!std::isfinite(moved)) return false;
            if (moved <= 1e-13 || (moved <= 1e-10 && moved >= 0.5 * previous)) {
                setEnd();
                return y1.allFinite();
            }
            previous = moved;
        }
        return false;
    }
    long long evaluations = 0;

private:
    Vector acceleration(const State& y, typename System::Mode mode)
    {
        ++evaluations;
        return system_.derivative(y, mode).template tail<half>();
    }

    const System& system_;
    NewmarkOptions options_;
};

} // namespace touchdown
