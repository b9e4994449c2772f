// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/search_watch.h"

#include <algorithm>

namespace touchdown {

std::string_view reason(NoBalance why)
{
    switch (why) {
    case NoBalance::None: return "";
    case NoBalance::AtDisk:
    case NoBalance::BelowDisk:
        return "the rails are pressed into the disk, so the film cannot balance the preload and its torques";
    case NoBalance::FarAway: return "the slider rises from the disk without end, so the film cannot hold it";
    case NoBalance::Stalled: return "the forces come no nearer to balance";
    case NoBalance::FilmUnsolved: return "the film's pressure was not found at several attitudes";
    }
    return {};
}

SearchWatch::SearchWatch(double startCorner, int patience, bool throughDisk)
    : highest_(std::max(highest, 2.0 * startCorner)), patience_(patience), throughDisk_(throughDisk)
{}

NoBalance SearchWatch::unsolved(double spacing)
{
    if (spacing < leastSane) return ++unsolvedLow_ > 1 ? NoBalance::AtDisk : NoBalance::None;
    return ++unsolved_ >= mostUnsolved ? NoBalance::FilmUnsolved : NoBalance::None;
}

NoBalance SearchWatch::look(const Attitude& attitude, const State& state, std::span<const double> pressure)
{
    if (state.solved && state.spacing >= leastSane && state.corner <= highest_) {
        sane_ = {attitude, state};
        pressure_.assign(pressure.begin(), pressure.end());
        leastSane_ = std::min(leastSane_, state.loadError);
    }
    constexpr double improved = 0.9; // of the least load error
    if (!started_ || state.loadError < improved * best_) {
        best_ = state.loadError;
        stalled_ = 0;
        started_ = true;
    } else {
        ++stalled_;
    }
    if (!throughDisk_ && state.spacing < touching) return NoBalance::AtDisk;
    if (state.spacing < -deepest) return NoBalance::BelowDisk;
    if (state.corner > highest_) return NoBalance::FarAway;
    return stalled_ > patience_ ? NoBalance::Stalled : NoBalance::None;
}

} // namespace touchdown
