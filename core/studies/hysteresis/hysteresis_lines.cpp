// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/simulation/small_motions/small_motions.h"
#include "core/studies/hysteresis/hysteresis_result.h"
#include "core/studies/study/few_digits.h"

namespace touchdown {

namespace {

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
        line.state = branch.contact == ContactRegion::Apart ? "flying" : "in contact";
        for (const Equilibrium& point : branch.points) line.points.push_back(studied(point));
        const bool frontLost = !branch.frontSpring && hasFront, rearLost = !branch.rearSpring && hasRear;
        if (frontLost) line.state += ", front spring lost";
        if (rearLost) line.state += ", rear spring lost";
        const auto below = [](const StudiedEquilibrium& at) { return at.spacing < 0.0; };
        line.outside = frontLost || rearLost || std::ranges::all_of(line.points, below);
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
        EquilibriumLine line{branch.contact == ContactRegion::Apart ? "flying" : "in contact", false, {}};
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
            " the waves that the disk drags along span fewer than ten cells, and the damping of oscillations there is "
            "known roughly; above " +
            fewDigits(result.resolved, "kHz", 2) + " not even its sign: take more film.nodes along the slider");
}

} // namespace touchdown
