// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/expected_cost.h"

#include <algorithm>
#include <cmath>

#include "core/case/case.h"
#include "core/case/integrator_kind.h"

namespace touchdown {

double expectedCost(const Case& c)
{
    const double duration = c.run.duration;
    if (c.model == ModelKind::Springs) {
        if (hasFixedStep(c.run.integrator)) return 4.0 * duration / c.run.step;
        // Of fifth order, an oscillation of a microsecond at a time.
        return 60.0 * duration / 1e-6 * std::pow(1e-8 / std::max(c.run.tolerance, 1e-14), 0.2);
    }
    if (c.model == ModelKind::Contact) return duration / c.run.sampleInterval;
    const double nodes = double(c.film.nodes[0]) * c.film.nodes[1];
    if (c.run.steps == StepControl::Fixed) return 4.0 * nodes * duration / c.run.step;
    return 4.0 * nodes * duration / 0.2e-6 * std::cbrt(5e-12 / c.run.stepError);
}

} // namespace touchdown
