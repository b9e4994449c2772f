// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis_result.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/fields.h"
#include "core/studies/few_digits.h"

namespace touchdown {

namespace {

constexpr double rounding = 1e-6; // of a span between two points of a line [-]

StudiedEquilibrium studied(const SpringEquilibrium& at)
{
    return {at.parameter, at.flyingHeight, at.q[1], at.stability, {at.eigenvalues.begin(), at.eigenvalues.end()}};
}

bool isDown(const EndState& end) { return end.kind == EndKind::Contact || end.kind == EndKind::Intermittent; }

} // namespace

void addSpringEquilibria(const SpringEquilibria& found, HysteresisResult& result)
{
    result.traced = true;
    for (const EquilibriumPiece& piece : found.pieces) {
        EquilibriumLine line;
        const bool lost = !piece.mode.frontSpring || !piece.mode.rearSpring;
        line.state = piece.mode.contact == ContactRegion::Apart ? "flying" : "in contact";
        for (const SpringEquilibrium& point : piece.points) line.points.push_back(studied(point));
        // A spring that was never there is not lost: then no line has it.
        const auto has = [&](bool SpringModel::Mode::*spring) {
            return std::ranges::any_of(found.pieces, [&](const EquilibriumPiece& each) { return each.mode.*spring; });
        };
        const bool frontLost = !piece.mode.frontSpring && has(&SpringModel::Mode::frontSpring);
        const bool rearLost = !piece.mode.rearSpring && has(&SpringModel::Mode::rearSpring);
        if (lost && frontLost) line.state += ", front spring lost";
        if (lost && rearLost) line.state += ", rear spring lost";
        const auto below = [](const StudiedEquilibrium& at) { return at.spacing < 0.0; };
        line.outside = frontLost || rearLost || std::ranges::all_of(line.points, below);
        result.lines.push_back(std::move(line));
    }
    for (const MarkedEquilibrium& mark : found.marks) {
        StudiedMark& added = result.marks.emplace_back(StudiedMark{mark.kind, mark.name, studied(mark.at), false});
        for (const EquilibriumLine& line : result.lines) {
            if (!line.outside || line.points.empty()) continue;
            const auto ends = [&](const StudiedEquilibrium& at) {
                return at.value == mark.at.parameter && at.spacing == mark.at.flyingHeight;
            };
            added.outside = added.outside || ends(line.points.front()) || ends(line.points.back());
        }
    }
    if (found.endsLost > 0)
        result.warnings.push_back(std::to_string(found.endsLost) +
                                  (found.endsLost == 1 ? " branch of equilibria ends" : " branches of equilibria end") +
                                  " within the range without a switch of the law: the case is not valid beyond, or no step led on");
}

std::string ParameterText::of(double value) const { return fewDigits(value, displayUnit, 4); }

ParameterText parameterText(const DesignKey& key)
{
    ParameterText text{key.key, key.unit, key.displayUnit};
    if (const Field* field = findField(key.key)) {
        text.label = field->label;
        text.label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text.label[0])));
        if (!field->symbol.empty()) text.label += " " + field->symbol;
    }
    return text;
}

std::vector<Transition> transitionsOf(const std::vector<HeldStep>& steps)
{
    std::vector<Transition> list;
    for (std::size_t i = 1; i < steps.size(); ++i) {
        const HeldStep &a = steps[i - 1], &b = steps[i];
        if (!a.done || !b.done || a.back != b.back) continue;
        if (a.end.kind == EndKind::Failed || b.end.kind == EndKind::Failed || isDown(a.end) == isDown(b.end)) continue;
        list.push_back({isDown(b.end), b.back, a.value, b.value});
    }
    return list;
}

LoopOf loopOf(const std::vector<HeldStep>& steps)
{
    LoopOf loop;
    const std::size_t count = steps.size() / 2;
    std::vector<double> differences;
    for (std::size_t i = 0; i < count; ++i) {
        const HeldStep &there = steps[i], &back = steps[2 * count - 1 - i];
        const bool known = there.done && back.done && there.end.kind != EndKind::Failed && back.end.kind != EndKind::Failed;
        loop.whole = loop.whole && known;
        differences.push_back(known ? std::abs(there.end.spacing - back.end.spacing) : 0.0);
        if (known && !sameEnd(there.end, back.end)) loop.values.push_back(there.value);
        if (i > 0 && known) loop.area += 0.5 * (differences[i] + differences[i - 1]) * std::abs(there.value - steps[i - 1].value);
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
            double share = a.value == b.value ? (a.value == value ? 0.0 : -1.0) : (value - a.value) / (b.value - a.value);
            // Where a line ends at the range's end, it does so but for rounding.
            if (i == 0 && std::abs(share) < rounding) share = 0.0;
            if (last && std::abs(share - 1.0) < rounding) share = 1.0;
            if (share < 0.0 || share > 1.0 || (share == 1.0 && !last)) continue;
            list.push_back({std::lerp(a.spacing, b.spacing, share), (share < 0.5 ? a : b).stability, line.outside});
        }
        if (line.points.size() == 1 && line.points[0].value == value)
            list.push_back({line.points[0].spacing, line.points[0].stability, line.outside});
    }
    return list;
}

} // namespace touchdown
