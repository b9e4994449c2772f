// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/work/team_gain.h"

#include <algorithm>
#include <chrono>

namespace touchdown {

namespace {

constexpr double leastGain = 1.03; // gain that is worth a second core

} // namespace

double TeamGain::now()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void TeamGain::note(std::uintptr_t loop, double seconds)
{
    const std::size_t half = phase_ == Phase::Together ? 1 : 0;
    std::size_t at = (loop >> 4 ^ loop >> 48) % loops_.size();
    for (std::size_t k = 0; k < loops_.size(); ++k, at = (at + 1) % loops_.size()) {
        Loop& place = loops_[at];
        if (place.key != 0 && place.key != loop) continue;
        place.key = loop;
        place.time[half] += seconds;
        ++place.calls[half];
        return;
    }
}

void TeamGain::look(double now)
{
    if (now < next_) return;
    switch (phase_) {
    case Phase::Use:
        loops_.fill({});
        phase_ = Phase::Alone;
        next_ = now + trial;
        return;
    case Phase::Alone:
        phase_ = Phase::Together;
        next_ = now + trial;
        return;
    case Phase::Together: break;
    }
    if (const double found = measured(); found > 0.0) {
        gain_ = gain_ > 0.0 ? 0.5 * (gain_ + found) : found;
        together_ = gain_ >= leastGain;
    }
    phase_ = Phase::Use;
    wait_ = std::min(longestWait, 2.0 * wait_);
    next_ = now + wait_;
}

double TeamGain::measured() const
{
    std::array<double, 2> sum{};
    for (const Loop& loop : loops_) {
        const auto [alone, all] = loop.calls;
        if (alone == 0 || all == 0) continue;
        const double weight = std::max(alone, all);
        sum[0] += loop.time[0] / alone * weight;
        sum[1] += loop.time[1] / all * weight;
    }
    return sum[1] > 0.0 ? sum[0] / sum[1] : 0.0;
}

} // namespace touchdown
