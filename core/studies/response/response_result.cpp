// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/response/response_result.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

namespace {

/// The jump on the way from one motion to its neighbour.
ResponseJump locatedJump(const ResponseTask& task, ForcedMotion before, ForcedMotion after, bool down, int halvings)
{
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (before.frequency + after.frequency);
        ForcedMotion motion = settledMotion(task.springsAt(middle), before.end, task.settle);
        if (task.settle.goOn && !task.settle.goOn()) break;
        const bool stays = motion.settled() && motion.period == before.period &&
                           std::abs(motion.harmonic - before.harmonic) < std::abs(motion.harmonic - after.harmonic);
        (stays ? before : after) = std::move(motion);
    }
    return {down,          before.frequency, after.frequency, before.amplitude(), after.amplitude(),
            before.period, after.period};
}

} // namespace

const ResponsePoint& pointAt(const ResponseResult& result, std::size_t place, bool down)
{
    return result.points[down ? result.points.size() - 1 - place : place];
}

std::vector<std::pair<std::size_t, std::size_t>> twoStates(const ResponseResult& result)
{
    std::vector<std::pair<std::size_t, std::size_t>> ranges;
    bool differs = false;
    for (std::size_t i = 0; i < result.points.size() / 2; ++i) {
        const ForcedMotion &up = pointAt(result, i, false).motion, &down = pointAt(result, i, true).motion;
        const bool before = differs;
        differs = up.settled() && down.settled() && !sameMotion(up, down);
        if (differs && before)
            ranges.back().second = i;
        else if (differs)
            ranges.emplace_back(i, i);
    }
    return ranges;
}

std::vector<ResponseJump> jumpsOf(const ResponseTask& task, const ResponseResult& result, int halvings)
{
    std::vector<ResponseJump> jumps;
    const std::size_t count = result.points.size() / 2;
    const auto add = [&](std::size_t from, std::size_t to, bool down) {
        const ForcedMotion &before = pointAt(result, from, down).motion, &after = pointAt(result, to, down).motion;
        if (after.settled()) jumps.push_back(locatedJump(task, before, after, down, halvings));
    };
    for (const auto& [first, last] : twoStates(result)) {
        if (first > 0) add(first, first - 1, true);
        if (last + 1 < count) add(last, last + 1, false);
    }
    return jumps;
}

ParameterText frequencyText() { return {"Frequency of the forcing", "Hz", "kHz"}; }

} // namespace touchdown
