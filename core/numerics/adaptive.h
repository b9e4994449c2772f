// SPDX-License-Identifier: GPL-3.0-or-later
//
// `dopri5`: Dormand-Prince 5(4) with error control, dense output and located switches.
//
// The mode is frozen within a step. A step whose dense output leaves the mode's intervals is repeated with the length
// that ends on the crossing to round-off. There the mode changes and the method restarts, so the order holds across
// switches. The whole dense output is searched for crossings (events.h), so that a short contact is not missed and no
// wall is jumped in one step. A crossing of a wall is accepted only if the energy of the step balances.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/numerics/events.h"
#include "core/numerics/runge_kutta.h"
#include "core/numerics/switched_system.h"

namespace touchdown {

struct AdaptiveOptions {
    double tolerance = 1e-8; // local error of a step, in units of System::scale; not below round-off of the state [-]
    double firstStep = 1e-9; // [s]
    double energyBalance = 0.01; // error of the energy in a step across a wall, of the energy there [-]
};

/// Simpson's rule for the work of the powers that are not the system's own, along a step [J].
template <SwitchedSystem System>
double workAlong(const System& system, const Segment<typename System::State>& segment, typename System::Mode mode)
{
    const double begin = system.power(segment.c[0], mode);
    const double middle = system.power(segment.at(segment.begin + 0.5 * segment.length), mode);
    const double end = system.power(segment.c[4], mode);
    return segment.length / 6.0 * (begin + 4.0 * middle + end);
}

/// Integrates from `start` over [0, until]. Calls of the recorder:
///   bool step(t, y, mode, at)   after an accepted step to time t; at(s) is the state at s within it; false stops
///   void event(t, guard, upper, before, after)
template <SwitchedSystem System, class Recorder>
IntegrationResult integrateAdaptive(const System& system, Start<System> start, double until,
                                    const AdaptiveOptions& options, Recorder& recorder)
{
    using State = typename System::State;
    constexpr double roundOff = 4.0 * std::numeric_limits<double>::epsilon();

    State y = start.y;
    const State inverseScale = system.scale().cwiseInverse() / options.tolerance;
    GuardWatch<System> watch(system, start.mode);
    const auto& mode = watch.mode();
    IntegrationResult result;

    std::array<State, 7> k;
    const auto derivative = [&](const State& at) { return system.derivative(at, mode); };
    const auto stages = [&](double h) {
        evaluateStages<dopri5Tableau>(y, h, k, derivative);
        result.evaluations += 6;
        return State(y + combine<TableauRow<dopri5Tableau, &Tableau<7>::b>, 6>(h, k));
    };
    const auto segmentOf = [&](double t, double h, const State& y1) {
        // y0 + x (r1 + (1-x) (r2 + x (r3 + (1-x) r4))), as Bernstein coefficients.
        const State r1 = y1 - y;
        const State r2 = h * k[0] - r1;
        const State r3 = r1 - h * k[6] - r2;
        const State r4 = combine<TableauRow<dopri5Tableau, &Tableau<7>::d>, 7>(h, k);
        return Segment<State>{t,
                              h,
                              {y, y + 0.25 * (r1 + r2), y + 0.5 * r1 + (1.0 / 3.0) * r2 + (1.0 / 6.0) * (r3 + r4),
                               y + 0.75 * r1 + 0.25 * (r2 + r3), y1}};
    };

    double t = 0.0;
    double h = std::min(options.firstStep, until);
    float previousLogError = -13.3f;
    k[0] = derivative(y);
    ++result.evaluations;
    bool rejected = false;
    // Weight of the squares in the error; smaller where the round-off of a large state exceeds the allowed error.
    const auto weightAt = [&](const State& at) {
        const double noise = roundOff * roundOff * at.cwiseProduct(inverseScale).squaredNorm();
        return 1.0 / (double(State::RowsAtCompileTime) * std::max(1.0, noise));
    };
    double weight = weightAt(y);

    bool cut = false; // a step, by the end
    const auto pass = [&](auto& stream) {
        stream(t, h, cut, y, k[0], weight, previousLogError, rejected, result.steps, result.rejectedSteps,
               result.evaluations, watch);
    };
    if constexpr (TakesCheckpoints<Recorder>) recorder.resume(pass);
    if (!(h > 0.0)) result.end = IntegrationEnd::Diverged; // of a damaged state
    while (t < until && result.end == IntegrationEnd::Reached) {
        if constexpr (TakesCheckpoints<Recorder>)
            if (recorder.isCheckpointDue(t)) recorder.sendCheckpoint(t, !cut, pass);
        const double smallest = 4.0 * std::numeric_limits<double>::epsilon() * std::max(t, options.firstStep);
        cut = cut || h > until - t;
        h = std::min(h, until - t);
        if constexpr (requires { system.longestStep(); }) h = std::min(h, system.longestStep());
        State y1 = stages(h);
        const double errorSquared =
            combine<TableauRow<dopri5Tableau, &Tableau<7>::e>, 7>(h, k).cwiseProduct(inverseScale).squaredNorm() *
            weight;

        if (!(errorSquared <= 1.0)) { // also if it is NaN
            ++result.rejectedSteps;
            rejected = true;
            h *= std::isfinite(errorSquared) ? std::max(0.1, 0.9 * std::pow(errorSquared, -0.1)) : 0.1;
            if (h < smallest) {
                result.end = std::isfinite(errorSquared) ? IntegrationEnd::StepUnderflow : IntegrationEnd::Diverged;
                break;
            }
            continue;
        }

        const double fullLength = h;
        Segment<State> segment = segmentOf(t, h, y1);
        std::optional<Crossing> crossing = watch.first(segment.c, t);
        if (crossing) {
            double length = crossing->at * h;
            if (t + length > t) {
                bool crossed = true;
                y1 = endOnCrossing(watch, *crossing, t, fullLength, length, crossed, stages);
                segment = segmentOf(t, length, y1);
                if (system.isWall(crossing->guard)) {
                    const double before = system.energy(y);
                    const double after = system.energy(y1);
                    const double made = after - before - workAlong(system, segment, mode);
                    if (!(std::abs(made) <= options.energyBalance * std::max(before, after))) {
                        ++result.rejectedSteps;
                        h = 0.25 * length;
                        if (h < smallest) {
                            result.end = IntegrationEnd::Tunnelled;
                            break;
                        }
                        continue;
                    }
                }
                if (!crossed) crossing.reset();
            } else {
                length = 0.0;
                y1 = y;
            }
            h = length;
        }

        const double t1 = h < until - t ? t + h : until;
        if (h > 0.0) {
            ++result.steps;
            if (!recorder.step(t1, y1, mode, [&](double s) { return segment.at(s); })) {
                result.end = IntegrationEnd::Stopped;
                t = t1;
                break;
            }
        }
        t = t1;
        y = y1;

        if (crossing && !watch.cross(t, crossing->guard, crossing->upper, y, recorder)) {
            result.end = IntegrationEnd::Chattering;
            break;
        }
        if (h < fullLength) { // cut short: the last stage is not the next step's first
            k[0] = derivative(y);
            ++result.evaluations;
            h = fullLength;
            continue;
        }
        k[0] = k[6];
        weight = weightAt(y);
        if (weight == 0.0) {
            result.end = IntegrationEnd::Diverged;
            break;
        }
        // PI step control (Hairer, Norsett & Wanner, II.4; beta = 0.04), in binary logarithms of single precision.
        const float logError = 0.5f * std::log2(std::max(static_cast<float>(errorSquared), 1e-20f));
        const float factor = 0.9f * std::exp2(0.04f * previousLogError - 0.17f * logError);
        previousLogError = std::max(logError, -13.3f); // log2(1e-4)
        h *= std::clamp(factor, 0.2f, rejected ? 1.0f : 10.0f);
        rejected = false;
    }
    result.time = t;
    return result;
}

} // namespace touchdown
