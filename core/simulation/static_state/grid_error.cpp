// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/grid_error.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady_result.h"

namespace touchdown {

namespace {

/// Shares of the difference from the next coarser grid [-].
constexpr double secondOrder = 0.5, firstOrder = 1.0;

/// Of what crossed cells carry, and more by the part of the cut faces that ridges part: what leaks through ridges moves
/// the pressure of whole rails [-].
constexpr double edgeShare = 0.035, perParted = 0.25;

double shareOfEdges(const FilmGaps& gaps)
{
    const double cut = static_cast<double>(gaps.faces[0].cut.size() + gaps.faces[1].cut.size());
    return edgeShare + perParted * static_cast<double>(gaps.partedFaces) / std::max(1.0, cut);
}

/// What crossed cells carry, those on either side of a face with rows (cut_rows.h): sums of |p - p0| area, and of these
/// times their arms about the slider's centre [N], [N m].
Vector3 edgeForces(const FilmLevel& level)
{
    const FilmGaps& gaps = level.gaps;
    std::vector<bool> crossed(gaps.pad.size(), false);
    for (const std::size_t axis : {0u, 1u})
        for (const CutPlace& place : gaps.faces[axis].cut)
            crossed[place.at] = crossed[place.at - gaps.pad.step(static_cast<int>(axis))] = true;
    Vector3 sum = Vector3::Zero();
    for (int j = 0; j < gaps.pad.ny; ++j)
        for (int i = 0; i < gaps.pad.nx; ++i) {
            const std::size_t at = gaps.pad.at(i, j);
            if (!crossed[at]) continue;
            const double force = std::abs(level.pressure[at] - level.film.ambient()) * level.film.areas()[at];
            sum += force * Vector3(1.0, std::abs(0.5 * gaps.length - gaps.grid.centreX(i)),
                                   std::abs(0.5 * gaps.width - gaps.grid.centreY(j)));
        }
    return sum;
}

} // namespace

DiscretisationError gridError(const Case& c, const FilmLevel& level, const std::optional<Matrix3>& stiffness,
                              const GridState& finest, std::span<const GridState> coarser,
                              std::span<const Vector3> ridges)
{
    const double share = !ridges.empty() && !c.steady.fixedAttitude ? firstOrder : secondOrder;
    const auto estimate = [&](double least, auto&& value) {
        const double last = std::abs(value(finest) - value(coarser[0]));
        const double before = coarser.size() > 1 ? std::abs(value(coarser[0]) - value(coarser[1])) : 0.0;
        return std::max({share * last, 0.125 * before, least});
    };
    Vector3 edges = shareOfEdges(level.gaps) * edgeForces(level);
    Matrix3 resisting = stiffness.value_or(Matrix3::Identity());
    if (c.degreesOfFreedom == 2) {
        holdRoll(resisting);
        edges[2] = 0.0;
    }
    double ridgeForce = 0.0; // [N]
    for (const Vector3& each : ridges) ridgeForce += std::abs(each[0]);
    // By how much the forces of crossed cells, and those of ridges, may move the attitude along a direction.
    const auto moved = [&](const Vector3& direction) {
        if (c.steady.fixedAttitude || !stiffness) return 0.0;
        const Vector3 byForces = solvePartialPivoting(resisting.transpose(), direction);
        double byRidges = 0.0;
        for (const Vector3& each : ridges)
            byRidges += std::abs(byForces.head<2>().dot(each.head<2>()) +
                                 (c.degreesOfFreedom == 2 ? 0.0 : byForces[2] * each[2]));
        return std::max(byForces.cwiseAbs().dot(edges), byRidges);
    };
    const double leastLoad = std::max(edges[0], ridgeForce);
    DiscretisationError error;
    error.pitch = estimate(moved({0.0, 1.0, 0.0}), [](const GridState& s) { return s.attitude.pitch; });
    error.roll = estimate(moved({0.0, 0.0, 1.0}), [](const GridState& s) { return s.attitude.roll; });
    const Vector3 spacing(1.0, c.slider.length - finest.nearest.x, 0.5 * c.slider.width - finest.nearest.y);
    error.minimumSpacing = estimate(moved(spacing), [](const GridState& s) { return s.minimumSpacing; });
    if (c.steady.fixedAttitude)
        error.load = estimate(leastLoad, [](const GridState& s) { return s.load; });
    else if (stiffness) {
        // The load that the coarser grid would miss at this attitude.
        const Vector3 row = stiffness->row(0);
        error.load = estimate(leastLoad, [&](const GridState& s) {
            return row[0] * s.attitude.height + row[1] * s.attitude.pitch + row[2] * s.attitude.roll;
        });
    } else
        error.load = estimate(leastLoad, [](const GridState& s) { return s.positive; });
    return error;
}

} // namespace touchdown
