// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fixed-step methods: `rk4`, which checks the state for switches once per step, as the paper's program does, and
// `rk4-events` and `newmark` with a frozen mode within the step and located switches.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/numerics/events.h"
#include "core/numerics/newmark.h"
#include "core/numerics/runge_kutta.h"
#include "core/numerics/switched_system.h"

namespace touchdown {

struct FixedStepOptions {
    double step = 1e-8;     // [s]
    double tunnelled = 0.5; // spurious energy of a step across a wall, of the energy before it, that ends the run [-]
};

/// Number of steps to `until`; the last one may be shorter.
inline long long stepCount(double until, double step)
{
    return std::max(1LL, static_cast<long long>(std::ceil(until / step * (1.0 - 1e-12))));
}

/// Whether a step from y0 to y1 crossed a wall with energy that the step itself produced.
template <SwitchedSystem System>
bool madeItsWay(const System& system, const typename System::State& y0, typename System::Mode mode0,
                const typename System::State& y1, typename System::Mode mode1, double h, double share)
{
    const double before = system.energy(y0);
    const double work = 0.5 * h * (system.power(y0, mode0) + system.power(y1, mode1));
    return !(std::abs(system.energy(y1) - before - work) <= share * before);
}

/// Classical Runge-Kutta; each stage selects its law by its own state, the hysteresis branch changes between steps.
/// Order 1 across a switch. Recorder as in adaptive.h.
template <SwitchedSystem System, class Recorder>
IntegrationResult integrateNaively(const System& system, Start<System> start, double until,
                                   const FixedStepOptions& options, Recorder& recorder)
{
    using State = typename System::State;
    State y = start.y;
    auto mode = start.mode;
    IntegrationResult result;
    std::array<State, 4> k;
    const long long count = stepCount(until, options.step);
    long long i = 1;
    const auto pass = [&](auto& stream) { stream(i, y, mode, result.time, result.steps, result.evaluations); };
    if constexpr (TakesCheckpoints<Recorder>) recorder.resume(pass);
    for (; i <= count; ++i) {
        const double t = double(i - 1) * options.step;
        if constexpr (TakesCheckpoints<Recorder>)
            if (recorder.isCheckpointDue(t)) recorder.sendCheckpoint(t, true, pass);
        const double t1 = i == count ? until : double(i) * options.step;
        const double h = t1 - t;
        const auto derivative = [&](const State& at) { return system.naiveDerivative(at, mode); };
        k[0] = derivative(y);
        evaluateStages<rk4Tableau>(y, h, k, derivative);
        const State y1 = y + combine<TableauRow<rk4Tableau, &Tableau<4>::b>, 4>(h, k);
        result.evaluations += 4;
        if (!std::isfinite(y1.sum())) {
            result.end = IntegrationEnd::Diverged;
            break;
        }
        const auto next = system.naiveMode(y1, mode);
        if (!(next == mode)) {
            for (int guard = 0; guard < System::guardCount; ++guard) {
                const double value = system.guards(y1.template head<GuardWatch<System>::half>())[guard];
                const Interval interval = system.interval(guard, mode);
                if (value >= interval.lower && value <= interval.upper) continue;
                if (system.isWall(guard) && madeItsWay(system, y, mode, y1, next, h, options.tunnelled)) {
                    result.end = IntegrationEnd::Tunnelled;
                    result.time = t;
                    return result;
                }
                recorder.event(t1, guard, value > interval.upper, mode, next);
            }
        }
        ++result.steps;
        result.time = t1;
        const auto at = [&](double s) {
            const Segment<State> segment{t, h, hermite(y, k[0], y1, derivative(y1), h)};
            return segment.at(s);
        };
        const bool goOn = recorder.step(t1, y1, next, at);
        y = y1;
        mode = next;
        if (!goOn) {
            result.end = IntegrationEnd::Stopped;
            break;
        }
    }
    return result;
}

/// Classical Runge-Kutta for a frozen mode.
template <SwitchedSystem System>
class Rk4Stepper {
public:
    explicit Rk4Stepper(const System& system) : system_(system) {}
    bool step(const typename System::State& y, typename System::Mode mode, double h, typename System::State& y1)
    {
        const auto derivative = [&](const typename System::State& at) { return system_.derivative(at, mode); };
        k_[0] = derivative(y);
        evaluateStages<rk4Tableau>(y, h, k_, derivative);
        y1 = y + combine<TableauRow<rk4Tableau, &Tableau<4>::b>, 4>(h, k_);
        evaluations += 4;
        return std::isfinite(y1.sum());
    }
    static constexpr IntegrationEnd failure = IntegrationEnd::Diverged;
    long long evaluations = 0;

private:
    const System& system_;
    std::array<typename System::State, 4> k_;
};

/// Any one-step method with a frozen mode; a step is repeated up to a switch. After a switch the rest of the step
/// follows, so that the times stay on the grid. Recorder as in adaptive.h.
template <SwitchedSystem System, class Stepper, class Recorder>
IntegrationResult integrateFixed(const System& system, Stepper stepper, Start<System> start, double until,
                                 const FixedStepOptions& options, Recorder& recorder)
{
    using State = typename System::State;
    constexpr int half = GuardWatch<System>::half;
    State y = start.y;
    GuardWatch<System> watch(system, start.mode);
    const auto& mode = watch.mode();
    IntegrationResult result;
    const long long count = stepCount(until, options.step);

    long long i = 1;
    const auto pass = [&](auto& stream) { stream(i, y, watch, result.time, result.steps, stepper.evaluations); };
    if constexpr (TakesCheckpoints<Recorder>) recorder.resume(pass);
    const auto integrate = [&]() -> IntegrationEnd {
        for (; i <= count; ++i) {
            double t = double(i - 1) * options.step;
            if constexpr (TakesCheckpoints<Recorder>)
                if (recorder.isCheckpointDue(t)) recorder.sendCheckpoint(t, true, pass);
            const double gridTime = i == count ? until : double(i) * options.step;
            bool onGrid = false;
            while (!onGrid) {
                double h = gridTime - t;
                State y1;
                if (!stepper.step(y, mode, h, y1)) return Stepper::failure;
                // Positions as the cubic through both ends; its velocities are not needed to find a crossing.
                const auto path = [&](const State& end, double length) {
                    State rate0 = State::Zero();
                    State rate1 = State::Zero();
                    rate0.template head<half>() = y.template tail<half>();
                    rate1.template head<half>() = end.template tail<half>();
                    return hermite(y, rate0, end, rate1, length);
                };
                std::optional<Crossing> crossing = watch.first(path(y1, h), t);
                double t1 = gridTime;
                if (crossing) {
                    double length = crossing->at * h;
                    if (t + length > t) {
                        bool crossed = true;
                        bool solved = true;
                        y1 = endOnCrossing(watch, *crossing, t, h, length, crossed, [&](double shorter) {
                            State end;
                            solved = stepper.step(y, mode, shorter, end) && solved;
                            return end;
                        });
                        if (!solved) return Stepper::failure;
                        if (system.isWall(crossing->guard) &&
                            madeItsWay(system, y, mode, y1, mode, length, options.tunnelled))
                            return IntegrationEnd::Tunnelled;
                        if (!crossed) crossing.reset();
                    } else {
                        length = 0.0;
                        y1 = y;
                    }
                    t1 = std::min(t + length, gridTime);
                    h = t1 - t;
                }
                result.time = t1;
                if (t1 > t) {
                    const auto at = [&](double s) {
                        const Segment<State> segment{
                            t, h, hermite(y, system.derivative(y, mode), y1, system.derivative(y1, mode), h)};
                        return segment.at(s);
                    };
                    if (!recorder.step(t1, y1, mode, at)) return IntegrationEnd::Stopped;
                }
                y = y1;
                t = t1;
                onGrid = !(t < gridTime);
                if (crossing && !watch.cross(t, crossing->guard, crossing->upper, y, recorder))
                    return IntegrationEnd::Chattering;
            }
            ++result.steps;
        }
        return IntegrationEnd::Reached;
    };
    result.end = integrate();
    result.evaluations = stepper.evaluations;
    return result;
}

} // namespace touchdown
