// SPDX-License-Identifier: GPL-3.0-or-later
//
// A slider on its air film, with all that a coupled step of time needs.
#pragma once

#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/simulation/flight/coupled_step.h"
#include "core/simulation/flight/film_on_cells.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown::test {

/// A sample case on a coarse grid, at ease with small tolerances, without snapshots.
inline Case coarseFlight(const std::string& name, int nodes = 33)
{
    Case c = openCase(name).value;
    c.film.nodes = {nodes, nodes};
    c.film.tolerance = 1e-11;
    c.steady.loadTolerance = 1e-10;
    c.steady.fixedAttitude = c.steady.stiffness = false;
    c.run.fieldSnapshots = 0;
    return c;
}

inline const Case& pico()
{
    static const Case c = coarseFlight("film_pico");
    return c;
}
inline const SteadyResult& picoAtRest()
{
    static const SteadyResult rest = steady(pico());
    return rest;
}

/// Begins at rest with the film of its attitude, moved from the static one.
struct FlyingSlider {
    Recess recess;
    MinimumSpacing spacing;
    FilmLevel level;
    SliderBody body;
    FilmOnCells film;
    CoupledStepper stepper;

    FlyingSlider(const Case& c, const SteadyResult& rest, const CoupledStepOptions& options, const Vector3& offset,
                 SliderContact* contact = nullptr)
        : recess(c.surface, c.slider.length, c.slider.width),
          spacing(c.surface, recess),
          level(c, recess, spacing, rest.grid),
          body(c, rest.attitude),
          film(level.film, body, contact, nullptr, options.film, level.pressure),
          stepper(film, body, contact, options)
    {
        level.gaps.pad.pad<double>(rest.pressure, level.pressure);
        SliderMotion motion;
        motion.q = body.coordinates(rest.attitude) + offset;
        level.film.setAttitude(body.attitude(motion.q));
        if (!level.flying.solveFilm(level.pressure, {.tolerance = 1e-12, .maximumIterations = 60}).converged)
            qFatal("the film of the start was not solved");
        stepper.start(motion, 0.0);
    }
    FlyingSlider(const FlyingSlider&) = delete;

    CoupledStepResult take(double dt)
    {
        const CoupledStepResult result = stepper.step(dt);
        if (result.converged()) stepper.accept();
        return result;
    }
    /// False where a step did not converge.
    bool takeAll(double duration, int count)
    {
        for (int n = 0; n < count; ++n)
            if (!take(duration / count).converged()) return false;
        return true;
    }
    const Vector3& q() const { return stepper.motion().q; }
    /// Distance of the corners from another position [m].
    double from(const Vector3& other) const { return body.displacement(q() - other); }
};

} // namespace touchdown::test
