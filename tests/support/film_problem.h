// SPDX-License-Identifier: GPL-3.0-or-later
//
// A film ready to be solved: surface, grid, setting and attitude in one place.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/physics/film/film_grid.h"
#include "core/physics/film/film_loads.h"
#include "core/physics/film/film_newton.h"
#include "core/physics/film/gaps/film_gaps.h"
#include "core/physics/film/gas_film.h"
#include "core/physics/slider/recess.h"

namespace touchdown::test {

struct FilmProblem {
    GasFilm film;
    const FilmGaps& gaps; // of the film
    FilmLoads loads;
    AttitudeWork attitudeWork;
    std::vector<double> p; // padded [Pa]

    FilmProblem(const AirBearingSurface& surface, double length, double width, CellGrid grid,
                const FilmSetting& setting, const Attitude& attitude)
        : film(std::make_shared<const FilmGaps>(Recess(surface, length, width), std::move(grid)), setting),
          gaps(film.gaps()),
          loads(film),
          attitudeWork(gaps),
          p(gaps.pad.size(), film.ambient())
    {
        film.setAttitude(attitude);
    }
    FilmProblem(const FilmProblem&) = delete;
    FilmProblem& operator=(const FilmProblem&) = delete;

    FilmSolution solve(const FilmOptions& options = {}) { return FilmNewton(film).solve(p, options); }
    double at(int i, int j) const { return p[gaps.pad.at(i, j)]; }
    /// Highest and lowest pressure of the cells [Pa].
    double peak() const { return *std::max_element(p.begin(), p.end()); }
    double lowest() const { return *std::min_element(p.begin(), p.end()); }
    double load() { return loads.load(p)[0]; } // [N]
    /// What is known for an adapted grid.
    KnownFilm known() const
    {
        KnownFilm known{gaps.grid, gaps.pad.unpad<double>(p), {}, film.ambient(), 0.0};
        for (int j = 0; j < gaps.pad.ny; ++j)
            for (int i = 0; i < gaps.pad.nx; ++i) known.gap.push_back(film.meanGap(i, j));
        return known;
    }
};

/// The same velocity everywhere, with its parts along x and y [m/s].
inline DiskMotion uniformMotion(double speed, double skew = 0.0)
{
    return {.speed = speed / 0.02, .radius = 0.02, .skew = skew, .field = VelocityField::Uniform};
}

/// No rails: the zero plane.
inline AirBearingSurface planeSurface()
{
    AirBearingSurface surface;
    surface.baseRecess = 0.0;
    return surface;
}

/// A step across and a shallow rail on a slider of 0.8 mm by 0.6 mm, so that all kinds of faces take part.
inline AirBearingSurface steppedSurface()
{
    AirBearingSurface surface;
    surface.baseRecess = 0.3e-6;
    surface.rails = {
        {.points = {{0.21e-3, 0.11e-3}, {0.8e-3, 0.17e-3}, {0.8e-3, 0.5e-3}, {0.21e-3, 0.5e-3}}, .recess = {0.0}}};
    return surface;
}

} // namespace touchdown::test
