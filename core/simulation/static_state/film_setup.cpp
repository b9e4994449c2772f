// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/film_setup.h"

#include <algorithm>

#include "core/simulation/static_state/steady_result.h"
#include "core/work/team.h"

namespace touchdown {

Air airOf(const AirCase& air)
{
    switch (air.source) {
    case AirSource::Atmosphere: return airAt(air.altitude, air.temperature);
    case AirSource::EstablishedStandard: return establishedStandardAir;
    case AirSource::Given: break;
    }
    return air.given;
}

FilmSetting filmSetting(const Case& c)
{
    return {.air = airOf(c.air),
            .slip = c.air.slip,
            .disk = c.disk,
            .scheme = c.film.scheme,
            .leastGap = c.contact == noContact ? 0.0 : moleculeGap};
}

std::vector<std::array<int, 2>> filmLevels(const FilmCase& film)
{
    constexpr int coarsest = 32; // cells along the shorter count: fewer do not see the rails
    if (film.accuracy > 0.0) return {{48, 48}, {96, 96}, {192, 192}, {384, 384}, {768, 768}, {1536, 1536}};
    std::array<int, 2> cells{film.nodes[0] - 1, film.nodes[1] - 1};
    std::vector<std::array<int, 2>> levels{cells};
    // Two grids at least, so that every result comes with an estimate of its error.
    while (cells[0] % 2 == 0 && cells[1] % 2 == 0 &&
           (levels.size() == 1 || std::min(cells[0], cells[1]) >= 2 * coarsest)) {
        cells = {cells[0] / 2, cells[1] / 2};
        levels.push_back(cells);
    }
    std::reverse(levels.begin(), levels.end());
    return levels;
}

namespace {

/// `cells`: with fewer a thread does not gain.
int threadsOf(const Case& c, int cells)
{
    constexpr int mostByItself = 8;            // loops end together, which costs more with each thread
    constexpr int cellsByAccuracy = 256 * 256; // where an accuracy chooses the grid, hardly ever more
    if (c.run.threads > 0) return std::min(c.run.threads, threadLimit());
    const std::array<int, 2> finest = filmLevels(c.film).back();
    const int all = finest[0] * finest[1];
    return std::clamp((c.film.accuracy > 0.0 ? std::min(all, cellsByAccuracy) : all) / cells, 1,
                      std::min(threadShare(), mostByItself));
}

} // namespace

int filmThreads(const Case& c) { return threadsOf(c, 65 * 65); }

int staticThreads(const Case& c) { return threadsOf(c, 256 * 256); }

std::size_t filmBytes(const Case& c)
{
    constexpr std::size_t perCell = 200 * sizeof(double); // measured: 1.6 kB
    if (c.model != ModelKind::Film) return 0;
    const std::array<int, 2> finest = filmLevels(c.film).back();
    return perCell * static_cast<std::size_t>(finest[0]) * static_cast<std::size_t>(finest[1]);
}

CellGrid unadaptedGrid(const Case& c, const std::array<int, 2>& cells)
{
    const double length = c.slider.length, width = c.slider.width;
    if (c.film.grid == GridKind::Uniform) return uniformGrid(length, width, cells[0], cells[1]);
    return gradedGrid(c.surface, length, width, cells[0], cells[1]);
}

double resolvedFrequency(const Case& c, const CellGrid& grid)
{
    return 0.5 * c.disk.speed * c.disk.radius * grid.nx() / (cellsForDamping * c.slider.length);
}

FilmLevel::FilmLevel(const Case& c, std::shared_ptr<const FilmGaps> shared, const MinimumSpacing& spacing)
    : film(std::move(shared), filmSetting(c)),
      gaps(film.gaps()),
      loads(film),
      flying(film, loads, sliderLoad(c), spacing),
      pressure(gaps.pad.size(), film.ambient())
{}

KnownFilm FilmLevel::known(const Case& c) const
{
    KnownFilm result{.grid = gaps.grid,
                     .pressure = gaps.pad.unpad<double>(pressure),
                     .gap = {},
                     .ambient = film.ambient(),
                     .draggedGap =
                         draggedGap(airOf(c.air).viscosity, c.disk.speed * c.disk.radius, gaps.length, film.ambient())};
    for (int j = 0; j < gaps.pad.ny; ++j)
        for (int i = 0; i < gaps.pad.nx; ++i) result.gap.push_back(film.meanGap(i, j));
    return result;
}

void FilmLevel::take(const KnownFilm& known)
{
    gaps.pad.pad<double>(transfer(known.grid, known.pressure, film.ambient(), gaps.grid), pressure);
}

void setState(SteadyResult& state, const Case& c, FilmLevel& level, const MinimumSpacing& spacing,
              const Attitude& attitude)
{
    state.attitude = attitude;
    const MinimumSpacing::Place nearest = spacing.at(attitude);
    state.minimumSpacing = nearest.spacing;
    state.minimumAt = nearest.at;
    state.forces = level.loads.forces(level.pressure);
    const double arm = sliderLoad(c).shearArm;
    state.shearPitchTorque = -arm * state.forces.shearX;
    state.shearRollTorque = -arm * state.forces.shearY;
    state.interestSpacing.clear();
    for (const SurfacePoint& point : c.surface.pointsOfInterest)
        state.interestSpacing.push_back(spacing.recess().at(point.x, point.y) +
                                        level.gaps.lift(attitude, point.x, point.y));
    KnownFilm fields = level.known(c);
    state.grid = std::move(fields.grid);
    state.pressure = std::move(fields.pressure);
    state.gap = std::move(fields.gap);
    state.recess = level.gaps.pad.unpad<double>(level.gaps.meanRecess);
    state.gaps = level.film.sharedGaps();
}

} // namespace touchdown
