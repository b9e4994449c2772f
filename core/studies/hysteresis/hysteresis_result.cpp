// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis/hysteresis_result.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/formats/units.h"
#include "core/simulation/static_state/film_setup.h"

namespace touchdown {

namespace {

constexpr double rounding = 1e-6; // of a span between two points of a line [-]

/// Of two that touch, one may be seen leaving the disk while it still rings. One that bounces on is another state.
bool differ(EndState a, EndState b)
{
    if (touches(a) != touches(b) || bounces(a) != bounces(b)) return true;
    b.kind = a.kind;
    a.spread = b.spread = 0.5 * (a.spread + b.spread); // how it rings there is no matter of the way
    return !sameEnd(a, b);
}

StudiedEquilibrium studied(const Equilibrium& at)
{
    return {at.parameter, at.spacing, at.q[1], at.stability, at.eigenvalues, at.lost, false};
}

/// Tells the points of lines that are folds or Hopf points.
void setEdges(HysteresisResult& result)
{
    for (const StudiedMark& mark : result.marks) {
        if (mark.kind != EquilibriumMark::Fold && mark.kind != EquilibriumMark::Hopf) continue;
        for (EquilibriumLine& line : result.lines)
            for (StudiedEquilibrium& at : line.points)
                at.edge = at.edge ||
                          (at.value == mark.at.value && at.spacing == mark.at.spacing && at.pitch == mark.at.pitch);
    }
}

void addLostEnds(int count, HysteresisResult& result)
{
    if (count > 0)
        result.warnings.push_back(
            std::to_string(count) + (count == 1 ? " branch of equilibria ends" : " branches of equilibria end") +
            " within the range without a switch of the law: the case is not valid beyond, or no step led on");
}

} // namespace

std::string EquilibriumLine::state() const
{
    return std::string(flying ? "flying" : "in contact") + (frontLost ? ", front spring lost" : "") +
           (rearLost ? ", rear spring lost" : "");
}

bool touches(const EndState& end) { return end.kind == EndKind::Contact || end.kind == EndKind::Intermittent; }

bool bounces(const EndState& end) { return end.motion == Motion::Bounces; }

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
    return step.done && step.end.kind != EndKind::Failed && !bounces(step.end) && !step.atRest();
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
        const bool alike = touches(there.end) == touches(back.end) && bounces(there.end) == bounces(back.end);
        if (known && differ(there.end, back.end) && !(moving && alike)) {
            loop.values.push_back(there.value);
            loop.ends.push_back({there.end, back.end});
            if (moving) ++loop.moving;
        }
        if (i > 0 && known)
            loop.area += 0.5 * (differences[i] + differences[i - 1]) * std::abs(there.value - steps[i - 1].value);
    }
    if (loop.values.size() > 1 && loop.values.front() > loop.values.back()) {
        std::ranges::reverse(loop.values);
        std::ranges::reverse(loop.ends);
    }
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
                            line.flying});
        }
        if (line.points.size() == 1 && line.points[0].value == value)
            list.push_back({line.points[0].spacing, line.points[0].stability, line.outside, line.points[0].incomplete(),
                            line.flying});
    }
    return list;
}

std::vector<ValueRange> rangesAlong(const std::vector<EquilibriumLine>& lines,
                                    const std::function<bool(const StudiedEquilibrium&)>& isSo)
{
    const auto is = [&](const StudiedEquilibrium& at) { return !at.edge && isSo(at); };
    std::vector<ValueRange> ranges;
    for (const EquilibriumLine& line : lines) {
        if (line.outside) continue;
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            if (!is(line.points[i])) continue;
            const std::size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, line.points.size() - 1);
            ValueRange range{line.points[i].value, line.points[i].value};
            for (const std::size_t k : {before, after}) {
                const StudiedEquilibrium& next = line.points[k];
                if (!is(next) && !next.edge) continue;
                range = {std::min(range.lower, next.value), std::max(range.upper, next.value)};
            }
            ranges.push_back(range);
        }
    }
    return merged(std::move(ranges));
}

std::vector<ValueRange> coexistence(const std::vector<EquilibriumLine>& lines)
{
    std::vector<double> ends;
    for (const EquilibriumLine& line : lines)
        for (const StudiedEquilibrium& at : line.points) ends.push_back(at.value);
    std::ranges::sort(ends);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const auto rests = [](const EquilibriumAt& at) {
        return !at.outside && !at.incomplete &&
               (at.stability == Stability::Stable || at.stability == Stability::Neutral);
    };
    std::vector<ValueRange> ranges;
    for (std::size_t i = 1; i < ends.size(); ++i)
        if (std::ranges::count_if(equilibriaAt(lines, std::midpoint(ends[i - 1], ends[i])), rests) > 1)
            ranges.push_back({ends[i - 1], ends[i]});
    ranges = merged(std::move(ranges));
    // Where one line ends and the next begins they may overlap by rounding.
    std::erase_if(ranges, [&](const ValueRange& range) {
        return range.upper - range.lower <= rangesMeet * (ends.back() - ends.front());
    });
    return ranges;
}

void addSpringEquilibria(const EquilibriumBranches& found, HysteresisResult& result)
{
    result.traced = true;
    // A spring that was never there is not lost: then no line has it.
    const auto has = [&](bool EquilibriumBranch::*spring) {
        return std::ranges::any_of(found.branches, [&](const EquilibriumBranch& each) { return each.*spring; });
    };
    const bool hasFront = has(&EquilibriumBranch::frontSpring), hasRear = has(&EquilibriumBranch::rearSpring);
    for (const EquilibriumBranch& branch : found.branches) {
        EquilibriumLine line;
        line.flying = branch.contact == ContactRegion::Apart;
        for (const Equilibrium& point : branch.points) line.points.push_back(studied(point));
        line.frontLost = !branch.frontSpring && hasFront;
        line.rearLost = !branch.rearSpring && hasRear;
        const auto below = [](const StudiedEquilibrium& at) { return at.spacing < 0.0; };
        line.outside = line.frontLost || line.rearLost || std::ranges::all_of(line.points, below);
        result.lines.push_back(std::move(line));
    }
    for (const MarkedEquilibrium& mark : found.marks) {
        StudiedMark& added = result.marks.emplace_back(StudiedMark{mark.kind, mark.name, studied(mark.at), false});
        for (const EquilibriumLine& line : result.lines) {
            const auto isHere = [&](const StudiedEquilibrium& at) {
                return at.value == mark.at.parameter && at.spacing == mark.at.spacing;
            };
            added.outside = added.outside || (line.outside && std::ranges::any_of(line.points, isHere));
        }
    }
    setEdges(result);
    addLostEnds(found.endsLost, result);
}

void addFilmEquilibria(const EquilibriumBranches& found, HysteresisResult& result)
{
    result.traced = true;
    result.unsought = !found.problems.empty() || found.givenUp > 0 || found.endsLost > 0;
    bool lost = false;
    double fastest = 0.0; // [Hz]
    for (const EquilibriumBranch& branch : found.branches) {
        EquilibriumLine line;
        line.flying = branch.contact == ContactRegion::Apart;
        for (const Equilibrium& point : branch.points) {
            line.points.push_back(studied(point));
            lost = lost || !line.points.back().followed();
            for (const auto& eigenvalue : point.eigenvalues)
                fastest = std::max(fastest, eigenvalue.imag() / (2.0 * std::numbers::pi));
        }
        result.lines.push_back(std::move(line));
    }
    if (found.resolved > 0.0) result.resolved = found.resolved * cellsForDamping / cellsForItsSign;
    for (const MarkedEquilibrium& mark : found.marks) {
        StudiedMark added{mark.kind, mark.name, studied(mark.at), false};
        // Where the grid gives damping a wrong sign, a change of sign means nothing.
        const auto& rates = added.at.eigenvalues;
        const bool unknown =
            mark.kind == EquilibriumMark::Hopf &&
            (rates.empty() || std::abs(rates.front().imag()) > 2.0 * std::numbers::pi * result.resolved);
        if (!unknown) result.marks.push_back(std::move(added));
    }
    for (const std::string& problem : found.problems)
        result.warnings.push_back(
            "at one value or more no equilibria were sought: there is no static state of the film: " + problem);
    if (found.givenUp > 0)
        result.warnings.push_back(
            "at " + std::to_string(found.givenUp) + (found.givenUp == 1 ? " value" : " values") +
            " the search for equilibria in contact did not come to its end from every start: one may be missed");
    setEdges(result);
    addLostEnds(found.endsLost, result);
    if (lost)
        result.warnings.push_back(
            "about some equilibria an oscillation could not be followed, or is damped so much that it is none");
    if (fastest > found.resolved && found.resolved > 0.0)
        result.warnings.push_back(
            "above " + fewDigits(found.resolved, "kHz", 2) +
            " a wave that the air carries along the slider spans fewer than six cells, and the damping of oscillations "
            "there is known roughly; above " +
            fewDigits(result.resolved, "kHz", 2) + " not even its sign: take more film.nodes along the slider");
}

} // namespace touchdown
