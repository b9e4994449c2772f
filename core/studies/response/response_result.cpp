// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/response/response_result.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/formats/words.h"

namespace touchdown {

namespace {

constexpr double fullCircle = 2.0 * std::numbers::pi; // [rad]
constexpr double roundOffOfTurn = 1e-12;              // [-]

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

double PhaseTurn::of(const std::complex<double>& harmonic) const
{
    const double phase = std::arg(std::complex<double>(0.0, 1.0) * harmonic);
    return phase - fullCircle * std::floor((phase - lowest) / fullCircle + roundOffOfTurn);
}

PhaseTurn phaseTurnOf(const ResponseResult& result)
{
    const PhaseTurn plain{-0.75 * fullCircle};
    std::vector<double> phases;
    for (const ResponsePoint& point : result.points)
        if (point.done && point.motion.valid()) phases.push_back(plain.of(point.motion.harmonic));
    for (const std::optional<std::complex<double>>& linear : result.linear)
        if (linear) phases.push_back(plain.of(*linear));
    if (phases.empty()) return plain;
    std::ranges::sort(phases);
    double lowest = phases.front(), highest = phases.back(), widest = fullCircle - (highest - lowest);
    for (std::size_t i = 1; i < phases.size(); ++i) {
        if (phases[i] - phases[i - 1] <= widest) continue;
        widest = phases[i] - phases[i - 1];
        lowest = phases[i];
        highest = phases[i - 1] + fullCircle;
    }
    return {0.5 * (lowest + highest) > 0.25 * fullCircle ? lowest - fullCircle : lowest};
}

std::string readableName(const Quantity& quantity)
{
    std::string name = quantity.name;
    std::ranges::replace(name, '_', ' ');
    return name;
}

ParameterText frequencyText() { return {"Frequency of the forcing", "Hz", "kHz"}; }

} // namespace touchdown
