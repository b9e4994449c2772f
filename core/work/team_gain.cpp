// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/work/team_gain.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

#include "core/work/team_trials.h"

namespace touchdown {

namespace {

constexpr double leastGain = 1.03;   // that is worth more than one core,
constexpr double gainToReturn = 1.1; // and for which loops are shared again: noise stays below [-]
constexpr double memory = 0.5;       // weight of the trials before [-]
constexpr double leastCalls = 0.5;   // of a kind of loop, below which it is gone

std::atomic<bool> trials = true;

} // namespace

void setTeamTrials(bool on) { trials = on; }

/// The place of a kind of loop, or a free one; null: there is none.
template <class Loops>
auto* placeOf(Loops& loops, std::uintptr_t key)
{
    std::size_t at = (key >> 4 ^ key >> 48) % loops.size();
    for (std::size_t k = 0; k < loops.size(); ++k, at = (at + 1) % loops.size())
        if (loops[at].key == 0 || loops[at].key == key) return &loops[at];
    return static_cast<typename Loops::value_type*>(nullptr);
}

double TeamGain::now()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void TeamGain::note(std::uintptr_t loop, double seconds)
{
    const std::size_t which = phase_ == Phase::Together ? 1 : 0;
    Loop* place = placeOf(loops_, loop);
    if (!place) return;
    place->key = loop;
    place->time[which] += seconds;
    place->calls[which] += 1.0;
}

void TeamGain::look(double now)
{
    if (now < next_ || (phase_ == Phase::Use && !trials)) return;
    switch (phase_) {
    case Phase::Use: begin(); break;
    case Phase::Alone: phase_ = Phase::Together; break;
    case Phase::Together:
        if (--rounds_ == 0) {
            decide();
            next_ = now + wait_;
            return;
        }
        phase_ = Phase::Alone;
        break;
    }
    next_ = now + half;
}

void TeamGain::begin()
{
    auto former = decltype(loops_){};
    std::swap(former, loops_);
    for (Loop& loop : former) {
        for (std::size_t k = 0; k < 2; ++k) loop.time[k] *= memory, loop.calls[k] *= memory;
        if (std::max(loop.calls[0], loop.calls[1]) >= leastCalls) *placeOf(loops_, loop.key) = loop;
    }
    rounds_ = lastRounds_ = std::min(mostRounds, lastRounds_ + 1);
    phase_ = Phase::Alone;
}

void TeamGain::decide()
{
    std::array<double, 2> sum{}; // of the kinds of loops that both halves had
    for (const Loop& loop : loops_) {
        const auto [alone, all] = loop.calls;
        if (alone == 0.0 || all == 0.0) continue;
        const double weight = std::max(alone, all);
        sum[0] += loop.time[0] / alone * weight;
        sum[1] += loop.time[1] / all * weight;
    }
    if (sum[1] > 0.0) {
        gain_ = sum[0] / sum[1];
        together_ = gain_ >= (together_ ? leastGain : gainToReturn);
    }
    phase_ = Phase::Use;
    wait_ = std::min(longestWait, 2.0 * wait_);
}

} // namespace touchdown
