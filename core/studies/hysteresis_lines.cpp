// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/studies/few_digits.h"
#include "core/studies/hysteresis_result.h"

namespace touchdown {

namespace {

/// Along a wave that the disk drags through the film, for the damping of its motion to 5 %, and for its sign: core/simulation/modes.cpp.
constexpr double cellsForDamping = 10.0, cellsForItsSign = 3.0;
constexpr double neighbours = 2e-9; // spacings of one line at neighbouring values differ by less [m]

StudiedEquilibrium studied(const SpringEquilibrium& at)
{
    return {at.parameter, at.flyingHeight, at.q[1], at.stability, {at.eigenvalues.begin(), at.eigenvalues.end()}, 0};
}

StudiedEquilibrium studied(double value, const FilmEquilibrium& at)
{
    return {value, at.spacing, at.attitude.pitch, at.stability, at.eigenvalues, at.lost};
}

/// Between two neighbouring values at which the stability differs by an oscillation: where the growth is zero on the line between.
void addCrossings(HysteresisResult& result)
{
    for (const EquilibriumLine& line : result.lines)
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const StudiedEquilibrium &a = line.points[i - 1], &b = line.points[i];
            const auto oscillates = [](const StudiedEquilibrium& at) {
                return at.stability == Stability::Stable || at.stability == Stability::Flutter;
            };
            if (a.stability == b.stability || !oscillates(a) || !oscillates(b)) continue;
            if (result.doubtful(a) || result.doubtful(b) || a.incomplete() || b.incomplete()) continue;
            const double growthA = a.growth().value_or(0.0), growthB = b.growth().value_or(0.0);
            const double share = growthA / (growthA - growthB);
            StudiedMark mark{EquilibriumMark::Hopf, "Hopf point", growthA > 0.0 ? a : b, false};
            mark.at.value = std::lerp(a.value, b.value, share);
            mark.at.spacing = std::lerp(a.spacing, b.spacing, share);
            mark.at.pitch = std::lerp(a.pitch, b.pitch, share);
            for (std::complex<double>& value : mark.at.eigenvalues)
                if (value == mark.at.eigenvalues.front()) value = {0.0, value.imag()};
            result.marks.push_back(std::move(mark));
        }
}

} // namespace

void addSpringEquilibria(const SpringEquilibria& found, HysteresisResult& result)
{
    result.traced = true;
    // A spring that was never there is not lost: then no line has it.
    const auto has = [&](bool SpringModel::Mode::*spring) {
        return std::ranges::any_of(found.pieces, [&](const EquilibriumPiece& each) { return each.mode.*spring; });
    };
    const bool hasFront = has(&SpringModel::Mode::frontSpring), hasRear = has(&SpringModel::Mode::rearSpring);
    for (const EquilibriumPiece& piece : found.pieces) {
        EquilibriumLine line;
        line.state = piece.mode.contact == ContactRegion::Apart ? "flying" : "in contact";
        for (const SpringEquilibrium& point : piece.points) line.points.push_back(studied(point));
        const bool frontLost = !piece.mode.frontSpring && hasFront, rearLost = !piece.mode.rearSpring && hasRear;
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
                return at.value == mark.at.parameter && at.spacing == mark.at.flyingHeight;
            };
            added.outside = added.outside || (line.outside && std::ranges::any_of(line.points, isHere));
        }
    }
    if (found.endsLost > 0)
        result.warnings.push_back(std::to_string(found.endsLost) +
                                  (found.endsLost == 1 ? " branch of equilibria ends" : " branches of equilibria end") +
                                  " within the range without a switch of the law: the case is not valid beyond, or no step led on");
}

void addFilmEquilibria(const std::vector<double>& values, const std::vector<FilmEquilibria>& found, HysteresisResult& result)
{
    result.traced = true;
    int lost = 0, givenUp = 0;
    double resolved = result.resolved, fastest = 0.0; // [Hz]
    for (std::size_t i = 0; i < found.size(); ++i) {
        std::vector<std::size_t> grown; // lines that have a point at this value
        if (!found[i].problem.empty())
            result.warnings.push_back("no equilibria were sought at value " + std::to_string(i + 1) + ": " + found[i].problem);
        if (!found[i].problem.empty() || found[i].givenUp > 0) result.unsought.push_back(values[i]);
        lost += found[i].lost;
        if (found[i].givenUp > 0) ++givenUp;
        if (found[i].resolved > 0.0) resolved = std::min(resolved, found[i].resolved);
        for (const FilmEquilibrium& at : found[i].found) {
            for (const auto& eigenvalue : at.eigenvalues) fastest = std::max(fastest, eigenvalue.imag() / (2.0 * std::numbers::pi));
            const std::string state = at.touching ? "in contact" : "flying";
            std::size_t best = result.lines.size();
            double nearest = neighbours;
            for (std::size_t k = 0; k < result.lines.size(); ++k) {
                const EquilibriumLine& line = result.lines[k];
                const bool goesOn = i > 0 && line.points.back().value == values[i - 1] && line.state == state;
                if (!goesOn || std::ranges::find(grown, k) != grown.end()) continue;
                const double distance = std::abs(line.points.back().spacing - at.spacing);
                if (distance >= nearest) continue;
                nearest = distance;
                best = k;
            }
            if (best == result.lines.size()) result.lines.push_back({state, at.spacing < 0.0, {}});
            result.lines[best].points.push_back(studied(values[i], at));
            grown.push_back(best);
        }
    }
    result.resolved = resolved * cellsForDamping / cellsForItsSign;
    addCrossings(result);
    if (givenUp > 0)
        result.warnings.push_back("at " + std::to_string(givenUp) + (givenUp == 1 ? " value" : " values") +
                                  " the search for equilibria in contact did not come to its end from every start: one may be missed");
    if (lost > 0)
        result.warnings.push_back(std::to_string(lost) + (lost == 1 ? " oscillation" : " oscillations") +
                                  " about equilibria could not be followed, or so much damped that there is none");
    if (fastest > resolved)
        result.warnings.push_back("above " + fewDigits(resolved, "kHz", 2) +
                                  " the waves that the disk drags along span fewer than ten cells, and the damping of oscillations there is "
                                  "known roughly; above " + fewDigits(result.resolved, "kHz", 2) +
                                  " not even its sign: take more film.nodes along the slider");
}

} // namespace touchdown
