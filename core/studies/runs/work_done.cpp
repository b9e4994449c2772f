// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/work_done.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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

WorkDone::WorkDone(std::vector<double> costs)
    : costs_(std::move(costs)), done_(costs_.size(), 0.0), all_(std::accumulate(costs_.begin(), costs_.end(), 0.0))
{}

ShareTeller WorkDone::teller(std::size_t i)
{
    return [this, i](double share) {
        const double before = std::exchange(done_[i], std::clamp(share, 0.0, 1.0));
        sum_.fetch_add(costs_[i] * (done_[i] - before));
    };
}

double WorkDone::share() const { return all_ > 0.0 ? std::clamp(sum_ / all_, 0.0, 1.0) : 1.0; }

} // namespace touchdown
