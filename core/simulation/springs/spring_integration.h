// SPDX-License-Identifier: GPL-3.0-or-later
//
// The integrator that the case names, on the springs over a flat disk or over one that moves.
#pragma once

#include "core/case/case.h"
#include "core/case/integrator_kind.h"
#include "core/numerics/adaptive.h"
#include "core/numerics/cvode.h"
#include "core/numerics/fixed_step.h"
#include "core/numerics/newmark.h"

namespace touchdown {

/// From the system's initial state; `step` [s] is for fixed-step integrators, `shortestPeriod` [s] that of the model.
template <class System, class Recorder>
IntegrationResult integrateSprings(const System& system, const Case& c, double step, double shortestPeriod,
                                   Recorder& recorder)
{
    const Start<System> start{system.initialState(), system.initialMode()};
    const double until = c.run.duration;
    const FixedStepOptions fixed{.step = step};
    const AdaptiveOptions adaptive{.tolerance = c.run.tolerance, .firstStep = 1e-3 * shortestPeriod};
    switch (c.run.integrator) {
    case IntegratorKind::Rk4: return integrateNaively(system, start, until, fixed, recorder);
    case IntegratorKind::Rk4Events:
        return integrateFixed(system, Rk4Stepper<System>(system), start, until, fixed, recorder);
    case IntegratorKind::Newmark: {
        const NewmarkOptions options{.beta = c.run.newmarkBeta, .gamma = c.run.newmarkGamma};
        return integrateFixed(system, NewmarkStepper<System>(system, options), start, until, fixed, recorder);
    }
    case IntegratorKind::Dopri5: break;
    case IntegratorKind::Cvode:
        if constexpr (haveCvode) return integrateCvode(system, start, until, adaptive, recorder);
        break;
    }
    return integrateAdaptive(system, start, until, adaptive, recorder);
}

} // namespace touchdown
