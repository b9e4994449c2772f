// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mechanical systems q" = a(q, q'; mode) whose law changes where a switching quantity leaves an interval.
//
// The state is y = (q, q'). Each switching quantity ("guard") is an affine function of q; a system whose guards are not
// affine says how they run along a step (guardPath below). In one mode every guard has the interval in which that
// mode's law holds; the law itself is smooth beyond the interval's ends, so that a step may look across an end before
// the switch is located (SUNDIALS, ARKODE guide, ERKStepReInit: the right-hand side must have a smooth extension).
//
// A law that depends on the time has it as a coordinate of q, whose velocity is 1. Optional members:
//
//   guardPath(c)    the guards' Bernstein coefficients along a step whose states have the coefficients c
//   guardScale()    typical sizes of the components of q for the round-off of guards, where those of scale() are others
//   longestStep()   of a step that still resolves the law's own changes in time [s]
#pragma once

#include <array>
#include <concepts>

#include <Eigen/Core>

#include "core/numerics/interval.h"

namespace touchdown {

template <class S>
concept SwitchedSystem = requires(const S& system, const typename S::State& y, typename S::Mode mode, int guard)
{
    requires std::convertible_to<decltype(S::guardCount), int>;
    /// dy/dt by the smooth law of a mode, whether or not y is inside its intervals.
    requires std::same_as<decltype(system.derivative(y, mode)), typename S::State>;
    /// dy/dt with every law chosen by y itself, and only the branch of a hysteresis taken from the mode.
    requires std::same_as<decltype(system.naiveDerivative(y, mode)), typename S::State>;
    /// The mode of y, when the branch was that of `mode` until now.
    requires std::same_as<decltype(system.naiveMode(y, mode)), typename S::Mode>;
    /// Guard values of the positions in y [unit of q], and their rates [unit of q/s].
    system.guards(y.template head<S::State::RowsAtCompileTime / 2>());
    system.guardRates(y);
    /// Sizes of a guard's coefficients: |guard(q)| <= guardSizes . |q|, for its round-off.
    system.guardSizes(guard).dot(y.template head<S::State::RowsAtCompileTime / 2>());
    requires std::same_as<decltype(system.interval(guard, mode)), Interval>;
    /// The mode beyond the upper or lower end of a guard's interval.
    requires std::same_as<decltype(system.beyond(mode, guard, true)), typename S::Mode>;
    /// Typical size of each component of y, against which an adaptive method's tolerance counts.
    requires std::same_as<decltype(system.scale()), typename S::State>;
    /// True when crossing the guard means to climb a potential wall, which an inaccurate step may jump.
    requires std::same_as<decltype(system.isWall(guard)), bool>;
    /// Shortest time scale of the motion near y [s].
    requires std::same_as<decltype(system.period(y, mode)), double>;
    /// Energy [J], and the power that is not its own [W]: dE/dt = power.
    requires std::same_as<decltype(system.energy(y)), double>;
    requires std::same_as<decltype(system.power(y, mode)), double>;
};

/// A step's dense output: polynomials of degree 4 in Bernstein form, so that their values lie between the
/// smallest and the largest coefficient.
template <class State>
struct Segment {
    double begin = 0.0;  // [s]
    double length = 0.0; // [s]
    std::array<State, 5> c;

    State at(double t) const
    {
        const double x = (t - begin) / length;
        const double w = 1.0 - x;
        const double xx = x * x;
        const double ww = w * w;
        return (ww * ww) * c[0] + (4.0 * ww * w * x) * c[1] + (6.0 * ww * xx) * c[2] + (4.0 * w * x * xx) * c[3] +
               (xx * xx) * c[4];
    }
};

/// The cubic through positions and velocities at both ends (Hermite), raised to degree 4.
template <class Vector>
std::array<Vector, 5> hermite(const Vector& y0, const Vector& dy0, const Vector& y1, const Vector& dy1, double h)
{
    const Vector b1 = y0 + (h / 3.0) * dy0;
    const Vector b2 = y1 - (h / 3.0) * dy1;
    return {y0, 0.25 * y0 + 0.75 * b1, 0.5 * (b1 + b2), 0.75 * b2 + 0.25 * y1, y1};
}

/// Why an integration ended.
enum class IntegrationEnd {
    Reached,       // the end time
    Stopped,       // by the recorder
    Diverged,      // a step made a value that is no number, or one beyond any use
    StepUnderflow, // the error test asks for steps below round-off
    NewtonFailed,  // an implicit step found no solution
    Chattering,    // switches follow each other without end
    Tunnelled,     // a step crossed a potential wall with energy that it made itself
};

struct IntegrationResult {
    IntegrationEnd end = IntegrationEnd::Reached;
    double time = 0.0;   // reached [s]
    long long steps = 0; // accepted
    long long rejectedSteps = 0;
    long long evaluations = 0; // of the right-hand side
};

/// A recorder may take the state of an integration, and give one back: pass(stream) names the numbers of the state.
///   bool isCheckpointDue(t), void sendCheckpoint(t, extends, pass), void resume(pass)
/// `extends`: no step was cut by the end of the integration, so that one to a later end goes the same way.
template <class Recorder>
concept TakesCheckpoints = requires(Recorder& recorder)
{
    recorder.isCheckpointDue(0.0);
};

/// Where a run starts.
template <SwitchedSystem System>
struct Start {
    typename System::State y;
    typename System::Mode mode;
};

} // namespace touchdown
