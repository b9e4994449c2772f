// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/work/work_done.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace touchdown {

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
