// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/ridge_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/physics/film/film_newton.h"
#include "core/physics/slider/recess.h"
#include "core/simulation/static_state/film_setup.h"

namespace touchdown {

namespace {

/// By which the walls of the edges are widened [-].
constexpr double wider = 1.15;

/// The adjoint films of force, pitch and roll torque, or of the first ones of them, padded [N/(Pa m^3/s)],
/// [N m/(Pa m^3/s)].
std::vector<std::vector<double>> loadAdjoints(FilmLevel& level, std::size_t count)
{
    FilmLoads::Derivatives loads;
    level.loads.derivatives(level.pressure, loads);
    FilmLinearSolver linear(level.film);
    linear.prepare();
    linear.prepareTransposed();
    std::vector<std::vector<double>> adjoints(count, std::vector<double>(level.pressure.size(), 0.0));
    for (std::size_t k = 0; k < count; ++k)
        linear.solveTransposed(loads.byPressure[k], adjoints[k], {.tolerance = 1e-3, .maximumIterations = 80});
    return adjoints;
}

double squaredDistance(double x, double y, const RailPoint& a, const RailPoint& b)
{
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double along = std::clamp(((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    const double offX = x - a.x - along * dx, offY = y - a.y - along * dy;
    return offX * offX + offY * offY;
}

std::size_t nearestEdge(const AirBearingSurface& surface, std::span<const RailEdge> edges, double x, double y)
{
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const std::vector<RailPoint>& points = surface.rails[edges[e].rail].points;
        const double distance =
            squaredDistance(x, y, points[edges[e].point], points[(edges[e].point + 1) % points.size()]);
        if (distance < least) least = distance, nearest = e;
    }
    return nearest;
}

} // namespace

std::vector<Vector3> ridgeErrors(const Case& c, FilmLevel& level, std::span<const RailEdge> edges)
{
    std::vector<Vector3> errors(edges.size(), Vector3::Zero());
    if (edges.empty()) return errors;
    const Recess recess(withWiderWalls(c.surface, edges, wider), c.slider.length, c.slider.width);
    GasFilm widerFilm(std::make_shared<const FilmGaps>(recess, level.gaps.grid), filmSetting(c));
    widerFilm.setAttitude(level.film.attitude());
    std::vector<double> change(level.pressure.size()), before(level.pressure.size());
    widerFilm.residual(level.pressure, change);
    level.film.linearise(level.pressure, before);
    // At a fixed attitude the torques move nothing.
    const std::vector<std::vector<double>> adjoints = loadAdjoints(level, c.steady.fixedAttitude ? 1 : 3);
    const FilmGaps& gaps = level.gaps;
    for (int j = 0; j < gaps.pad.ny; ++j)
        for (int i = 0; i < gaps.pad.nx; ++i) {
            const std::size_t at = gaps.pad.at(i, j);
            const double difference = change[at] - before[at];
            if (difference == 0.0) continue;
            const std::size_t edge = nearestEdge(c.surface, edges, gaps.grid.centreX(i), gaps.grid.centreY(j));
            for (std::size_t k = 0; k < adjoints.size(); ++k)
                errors[edge][static_cast<Eigen::Index>(k)] -= adjoints[k][at] * difference;
        }
    return errors;
}

} // namespace touchdown
