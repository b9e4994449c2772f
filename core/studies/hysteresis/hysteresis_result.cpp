// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis/hysteresis_result.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchdown {

namespace {

constexpr double rounding = 1e-6; // of a span between two points of a line [-]

/// Of two that touch, one may be seen leaving the disk while it still rings.
bool differ(EndState a, EndState b)
{
    if (touches(a) != touches(b)) return true;
    b.kind = a.kind;
    a.spread = b.spread = 0.5 * (a.spread + b.spread); // how it rings there is no matter of the way
    return !sameEnd(a, b);
}

} // namespace

bool touches(const EndState& end) { return end.kind == EndKind::Contact || end.kind == EndKind::Intermittent; }

bool HysteresisResult::doubtful(const StudiedEquilibrium& at) const
{
    return !at.edge && at.stability == Stability::Flutter && !at.eigenvalues.empty() &&
           std::abs(at.eigenvalues.front().imag()) > 2.0 * std::numbers::pi * resolved;
}

std::vector<Transition> transitionsOf(const std::vector<HeldStep>& steps)
{
    std::vector<Transition> list;
    for (std::size_t i = 1; i < steps.size(); ++i) {
        const HeldStep &a = steps[i - 1], &b = steps[i];
        if (!a.done || !b.done || a.back != b.back) continue;
        if (a.end.kind == EndKind::Failed || b.end.kind == EndKind::Failed || touches(a.end) == touches(b.end))
            continue;
        list.push_back({touches(b.end), b.back, a.value, b.value, a.end.spacing, b.end.spacing});
    }
    return list;
}

bool stillMoves(const HeldStep& step)
{
    return step.done && step.end.kind != EndKind::Failed && step.end.kind != EndKind::Intermittent && !step.atRest();
}

bool allFailed(const std::vector<HeldStep>& steps)
{
    return std::ranges::all_of(steps,
                               [](const HeldStep& step) { return step.done && step.end.kind == EndKind::Failed; });
}

LoopOf loopOf(const std::vector<HeldStep>& steps)
{
    LoopOf loop;
    const std::size_t count = steps.size() / 2;
    std::vector<double> differences;
    for (std::size_t i = 0; i < count; ++i) {
        const HeldStep &there = steps[i], &back = steps[2 * count - 1 - i];
        const bool known =
            there.done && back.done && there.end.kind != EndKind::Failed && back.end.kind != EndKind::Failed;
        loop.whole = loop.whole && known;
        differences.push_back(known ? std::abs(there.end.spacing - back.end.spacing) : 0.0);
        if (known) ++loop.known;
        const bool moving = stillMoves(there) || stillMoves(back);
        // Two that fly, or touch, and have not come to rest are no two states.
        if (known && differ(there.end, back.end) && !(moving && touches(there.end) == touches(back.end))) {
            loop.values.push_back(there.value);
            if (moving) ++loop.moving;
        }
        if (i > 0 && known)
            loop.area += 0.5 * (differences[i] + differences[i - 1]) * std::abs(there.value - steps[i - 1].value);
    }
    std::ranges::sort(loop.values);
    return loop;
}

std::vector<EquilibriumAt> equilibriaAt(const std::vector<EquilibriumLine>& lines, double value)
{
    std::vector<EquilibriumAt> list;
    for (const EquilibriumLine& line : lines) {
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
            const StudiedEquilibrium &a = line.points[i], &b = line.points[i + 1];
            const bool last = i + 2 == line.points.size();
            // Half open, so that a point between two spans counts once.
            double share =
                a.value == b.value ? (a.value == value ? 0.0 : -1.0) : (value - a.value) / (b.value - a.value);
            // Where a line ends at the range's end, it does so but for rounding.
            if (i == 0 && std::abs(share) < rounding) share = 0.0;
            if (last && std::abs(share - 1.0) < rounding) share = 1.0;
            if (share < 0.0 || share > 1.0 || (share == 1.0 && !last)) continue;
            const StudiedEquilibrium& nearer = a.edge != b.edge ? (a.edge ? b : a) : share < 0.5 ? a : b;
            list.push_back({std::lerp(a.spacing, b.spacing, share), nearer.stability, line.outside, nearer.incomplete(),
                            line.flies()});
        }
        if (line.points.size() == 1 && line.points[0].value == value)
            list.push_back({line.points[0].spacing, line.points[0].stability, line.outside, line.points[0].incomplete(),
                            line.flies()});
    }
    return list;
}

} // namespace touchdown
