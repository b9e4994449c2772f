// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the film is discretised and solved, and what its static state is asked for.
#include "core/case/field_builders.h"

namespace touchdown {

using namespace field_builders;

namespace {

constexpr std::size_t longestSeries = 100;
constexpr const char* oneState = "ours: one state, at the values of [disk] and [air]";

/// The film alone is solved, so that nothing answers to a load.
bool withFreeAttitude(const Case& c) { return withFilm(c) && !c.steady.fixedAttitude; }

} // namespace

std::vector<Field> filmFields()
{
    using enum FieldKind;
    return {
        list({.key = "film.nodes",
              .label = "nodes",
              .minimum = 17,
              .maximum = 2049,
              .stride = 16,
              .minimumCount = 2,
              .maximumCount = 2,
              .help = "Grid lines along and across the slider, 16 k + 1 each.",
              .source = "ours"},
             at(&Case::film, &FilmCase::nodes), withFilm),
        choice({.key = "film.grid",
                .label = "grid",
                .choices = {"uniform", "graded", "adapted"},
                .help = "Spacing of the grid lines: uniform; graded = snapped to the edges of rails; adapted = also "
                        "crowded where the "
                        "pressure bends.",
                .source = "ours"},
               at(&Case::film, &FilmCase::grid), withFilm),
        choice({.key = "film.scheme",
                .label = "convection scheme",
                .choices = {"upwind", "hybrid", "power-law", "exponential", "complete-flux"},
                .help = "How the air that the disk drags along is weighted on cell faces: upwind, hybrid and power-law "
                        "(Patankar 1980), "
                        "exponential = exact for a plane flow between two nodes, complete-flux = second order at any "
                        "Peclet number.",
                .source = "paper, section 2: power law; complete flux: ten Thije Boonkkamp & Anthonissen 2011"},
               at(&Case::film, &FilmCase::scheme), withFilm),
        choice({.key = "film.solver",
                .label = "solver",
                .choices = {"newton", "line-multigrid"},
                .help =
                    "Solution of the film in a static state: newton = Newton's method with the exact Jacobian, "
                    "line-multigrid = alternating line sweeps with full multigrid. A step in time is always solved by "
                    "Newton's method.",
                .source = "paper, section 2: line sweeps with multigrid; ours: newton"},
               at(&Case::film, &FilmCase::solver), withFilm),
        number({.key = "film.tolerance",
                .label = "residual tolerance",
                .minimum = 1e-13,
                .maximum = 1e-2,
                .help =
                    "Net mass flow of the cells, summed, against the flow through the film, at which the film of a "
                    "static state "
                    "or at the start of a run is solved; its steps in time are solved as far as run.step_error asks.",
                .source = "ours"},
               at(&Case::film, &FilmCase::tolerance), withFilm),
        plain(Integer,
              {.key = "film.maximum_iterations",
               .label = "most iterations",
               .minimum = 1,
               .maximum = 10000,
               .help = "Iterations on one grid after which the film of a static state counts as not converged.",
               .source = "ours"},
              at(&Case::film, &FilmCase::maximumIterations), withFilm),
        choice(
            {.key = "film.coupling",
             .label = "coupling",
             .choices = {"monolithic", "staggered"},
             .help =
                 "How film and slider are solved together in a step of time: monolithic = one Newton's method on "
                 "pressure and attitude, staggered = in turns, until neither changes. Both solve the same equations; "
                 "staggered wants short steps.",
             .source = "paper, section 2: staggered; ours: monolithic"},
            at(&Case::film, &FilmCase::coupling), withFilm),
    };
}

std::vector<Field> steadyFields()
{
    using enum FieldKind;
    return {
        plain(Boolean,
              {.key = "steady.fixed_attitude",
               .label = "fixed attitude",
               .help = "Whether the film is solved at the initial attitude only, instead of finding the attitude at "
                       "which it carries the load.",
               .source = "ours: the slider flies"},
              at(&Case::steady, &SteadyCase::fixedAttitude), withFilm),
        plain(Boolean,
              {.key = "steady.stiffness",
               .label = "stiffness matrix",
               .help = "Whether the stiffness matrix of the film is computed.",
               .source = "ours"},
              at(&Case::steady, &SteadyCase::stiffness), withFilm),
        plain(Boolean,
              {.key = "steady.sensitivities",
               .label = "sensitivities",
               .help = "Whether the answers of the attitude to the continuous parameters are computed.",
               .source = "ours"},
              at(&Case::steady, &SteadyCase::sensitivities), withFreeAttitude),
        plain(Boolean,
              {.key = "steady.all_equilibria",
               .label = "all equilibria",
               .help = "Whether more than one attitude of balance is looked for.",
               .source = "ours"},
              at(&Case::steady, &SteadyCase::allEquilibria), withFreeAttitude),
        number(
            {.key = "steady.load_tolerance",
             .label = "load tolerance",
             .minimum = 1e-12,
             .maximum = 1e-1,
             .help = "Imbalance at which the attitude is found: |dF| + |dT_pitch|/L + |dT_roll|/L against the preload.",
             .source = "ours"},
            at(&Case::steady, &SteadyCase::loadTolerance), withFreeAttitude),
        number({.key = "steady.shear_arm",
                .label = "arm of the air shear",
                .minimum = 0,
                .maximum = 1,
                .help = "Arm of the air's shear force about the pivot, in thicknesses of the slider; the established "
                        "static program takes 1.",
                .source = "geometry: the mass centre is at half the thickness"},
               at(&Case::steady, &SteadyCase::shearArm), withFilm),
        number({.key = "steady.torque_sign",
                .label = "sign of the shear torque",
                .minimum = -1,
                .maximum = 1,
                .help =
                    "Factor on the torques of the air's shear: 1 = its pitch torque presses the nose down, -1 = up, "
                    "0 = they are left out.",
                .source = "geometry"},
               at(&Case::steady, &SteadyCase::torqueSign), withFilm),
        list({.key = "steady.radii",
              .label = "radii of a series",
              .unit = "m",
              .displayUnit = "mm",
              .minimum = 0,
              .maximum = 1,
              .minimumAllowed = false,
              .maximumCount = longestSeries,
              .help = "Radii of a series of static states; empty = disk.radius alone.",
              .source = oneState},
             at(&Case::steady, &SteadyCase::radii), withFilm),
        list({.key = "steady.skews",
              .label = "skews of a series",
              .unit = "rad",
              .displayUnit = "deg",
              .minimum = -1.5,
              .maximum = 1.5,
              .maximumCount = longestSeries,
              .help = "Skews of a series, one for each of steady.radii; empty = disk.skew at all of them.",
              .source = oneState},
             at(&Case::steady, &SteadyCase::skews), withFilm),
        list({.key = "steady.speeds",
              .label = "speeds of a series",
              .unit = "rad/s",
              .displayUnit = "rpm",
              .minimum = 0,
              .maximum = 1e5,
              .maximumCount = longestSeries,
              .help = "Disk speeds of a series; empty = disk.speed alone.",
              .source = oneState},
             at(&Case::steady, &SteadyCase::speeds), withFilm),
        list({.key = "steady.altitudes",
              .label = "altitudes of a series",
              .unit = "m",
              .displayUnit = "m",
              .minimum = -1000,
              .maximum = 20000,
              .maximumCount = longestSeries,
              .help = "Altitudes of a series, each with the air of the standard atmosphere at air.temperature; empty = "
                      "the air as it is.",
              .source = oneState},
             at(&Case::steady, &SteadyCase::altitudes), withFilm),
    };
}

} // namespace touchdown
