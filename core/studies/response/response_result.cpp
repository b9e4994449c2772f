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

const ResponseJump* jumpBetween(const ResponseTask& task, const ResponseResult& result, std::size_t place,
                                std::size_t next, bool down)
{
    const double from = task.frequencies[place], to = task.frequencies[next];
    const ResponseJump* last = nullptr;
    for (const ResponseJump& jump : result.jumps) {
        const double at = jump.frequency();
        if (jump.down != down || jump.other != 0 || at < std::min(from, to) || at > std::max(from, to)) continue;
        if (last == nullptr || std::abs(at - from) > std::abs(last->frequency() - from)) last = &jump;
    }
    return last;
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
    for (const OtherMotion& other : result.others)
        for (const ForcedMotion& motion : other.motions) phases.push_back(plain.of(motion.harmonic));
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
