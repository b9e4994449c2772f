// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/steady_near.h"

#include <cmath>
#include <utility>

#include "core/simulation/static_state/contact_rest.h"
#include "core/simulation/static_state/film_balance.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/static_check.h"
#include "core/work/team.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

constexpr int mostIterations = 20;   // where the change is small, five do
constexpr double onLine = 1e-10;     // distance of an edge from its line [m]
constexpr double leastStretch = 0.5; // of the cells between two lines [-]

/// Nothing where no state is found nearby.
std::optional<SteadyResult> followed(const Case& c, const SteadyResult& from, const SteadyCallback& callback)
{
    const std::unique_ptr<FilmBalance> film = FilmBalance::at(c, from);
    if (!whyNoStaticState(c, film->spacings()).empty()) return {};
    FilmLevel& level = film->level();
    SteadyResult result;
    result.attitude = from.attitude;
    const auto monitor = [&](int iteration, double residual, double loadError, const Attitude& attitude) {
        return !callback || callback({"nearby", iteration, residual, loadError, attitude});
    };
    const AttitudeSolution solution = level.flying.solve(level.pressure, result.attitude,
                                                         {.filmTolerance = c.film.tolerance,
                                                          .loadTolerance = c.steady.loadTolerance,
                                                          .maximumIterations = mostIterations,
                                                          .patience = mostIterations,
                                                          .throughDisk = false},
                                                         monitor);
    result.iterations = solution.iterations;
    result.solves = solution.solves;
    result.residual = solution.residual;
    result.loadError = solution.loadError;
    if (solution.cancelled) {
        result.status = SteadyStatus::Cancelled;
        return result;
    }
    if (!solution.converged || !(film->spacings().at(result.attitude).spacing > 0.0)) return {};
    level.film.setAttitude(result.attitude);
    result.status = SteadyStatus::Converged;
    setState(result, c, level, film->spacings(), result.attitude);
    return result;
}

} // namespace

std::optional<CellGrid> movedGrid(const CellGrid& grid, const AirBearingSurface& before, const AirBearingSurface& now)
{
    std::vector<double> fromX, toX, fromY, toY;
    if (before.rails.size() != now.rails.size()) return {};
    for (std::size_t i = 0; i < now.rails.size(); ++i) {
        const std::vector<RailPoint>&a = before.rails[i].points, &b = now.rails[i].points;
        if (a.size() != b.size()) return {};
        for (std::size_t k = 0; k < a.size(); ++k) {
            fromX.push_back(a[k].x), toX.push_back(b[k].x);
            fromY.push_back(a[k].y), toY.push_back(b[k].y);
        }
    }
    auto x = movedLines(grid.x, fromX, toX), y = movedLines(grid.y, fromY, toY);
    if (!x || !y) return {};
    return CellGrid{std::move(*x), std::move(*y)};
}

std::optional<std::vector<double>> movedLines(const std::vector<double>& lines, const std::vector<double>& from,
                                              const std::vector<double>& to)
{
    // Which lines lie on an edge, and where they go. An edge that stays holds its line.
    std::vector<std::optional<double>> goal(lines.size());
    goal.front() = lines.front();
    goal.back() = lines.back();
    for (std::size_t i = 1; i + 1 < lines.size(); ++i)
        for (std::size_t k = 0; k < from.size(); ++k)
            if (std::abs(from[k] - lines[i]) < onLine && (!goal[i] || to[k] == from[k]))
                goal[i] = lines[i] + (to[k] - from[k]);
    std::vector<double> moved = lines;
    for (std::size_t begin = 0; begin + 1 < lines.size();) {
        std::size_t end = begin + 1;
        while (!goal[end]) ++end;
        const double stretch = (*goal[end] - *goal[begin]) / (lines[end] - lines[begin]);
        if (!(stretch > leastStretch)) return {};
        const bool stays = *goal[begin] == lines[begin] && *goal[end] == lines[end];
        for (std::size_t i = begin; i < end && !stays; ++i)
            moved[i] = *goal[begin] + stretch * (lines[i] - lines[begin]);
        moved[end] = *goal[end];
        begin = end;
    }
    return moved;
}

SteadyResult steadyNear(const Case& c, const Case& before, const SteadyResult& from, const SteadyCallback& callback)
{
    const double start = wallClock();
    const TeamScope team(staticThreads(c));
    std::optional<SteadyResult> result;
    const bool asLarge = c.slider.length == before.slider.length && c.slider.width == before.slider.width;
    if (from.status == SteadyStatus::Converged && !from.pressure.empty() && !c.steady.fixedAttitude && asLarge)
        if (auto grid = movedGrid(from.grid, before.surface, c.surface)) {
            SteadyResult moved = from;
            moved.grid = std::move(*grid);
            if (c.surface != before.surface) moved.gaps = nullptr;
            result = from.contact.acts() ? touchingNear(c, moved, callback) : followed(c, moved, callback);
            // A slider that came down to its contact.
            if (result && !from.contact.acts() && !from.contact.state.empty() &&
                actsInFlight(c, *result, [&] { return !callback || callback(progressAbout(*result, "contact")); }))
                result.reset();
            if (result && !from.contact.acts()) result->contact.state = from.contact.state;
        }
    const bool alone = from.status == SteadyStatus::Converged && from.contact.state.empty();
    if (!result) result = alone ? steady(c, callback) : steadyWithContact(c, callback);
    result->wallSeconds = wallClock() - start;
    return *result;
}

} // namespace touchdown
