// SPDX-License-Identifier: GPL-3.0-or-later
//
// Discretisation and solution of the film, and options of its static state.
#include "core/case/parameter_builders.h"

namespace touchdown {

using namespace parameter_builders;

namespace {

constexpr std::size_t longestSeries = 100;
constexpr const char* oneState = "ours: one state, at the values of [disk] and [air]";

/// With a fixed attitude only the film is solved, without a balance of loads.
bool withFullFilm(const Case& c) { return withFilm(c) && c.film.motion == FilmMotion::Full; }
bool withLinearFilm(const Case& c) { return withFilm(c) && c.film.motion == FilmMotion::Linear; }
bool withFreeAttitude(const Case& c) { return withFilm(c) && !c.steady.fixedAttitude; }

} // namespace

std::vector<Parameter> filmParameters()
{
    return {
        list("film.nodes", "nodes", noUnit, Range{17, 2049, true, 16}, Count{2, 2}, at(&Case::film, &FilmCase::nodes),
             withFilm, "Grid lines along and across the slider, 16 k + 1 each.", "ours"),
        number("film.accuracy", "accuracy", "", noUnit, between(0.0, 0.1), at(&Case::film, &FilmCase::accuracy),
               withFilm,
               "Largest relative error of a static state: of the net force at a fixed attitude, else of the minimum "
               "spacing, both as estimated. Grids of 49, 97, 193, ... up to 1537 lines each way are tried until it is "
               "reached, in place of film.nodes; 0 = film.nodes. A run in time takes the grid of its static state.",
               "ours: 0"),
        choice("film.grid", "grid", {"uniform", "graded", "adapted"}, at(&Case::film, &FilmCase::grid), withFilm,
               "Spacing of the grid lines: uniform; graded = snapped to the edges of rails; adapted = also denser "
               "where the pressure profile bends.",
               "ours"),
        choice("film.scheme", "convection scheme", {"upwind", "hybrid", "power-law", "exponential", "complete-flux"},
               at(&Case::film, &FilmCase::scheme), withFilm,
               "Discretisation of the Couette flow on cell faces: upwind, hybrid and power-law (Patankar 1980), "
               "exponential = exact for a plane flow between two nodes, complete-flux = second order at any Peclet "
               "number.",
               "paper, section 2: power law; complete flux: ten Thije Boonkkamp & Anthonissen 2011"),
        choice(
            "film.solver", "solver", {"newton", "line-multigrid"}, at(&Case::film, &FilmCase::solver), withFilm,
            "Solution of the film in a static state: newton = Newton's method with the exact Jacobian, line-multigrid "
            "= alternating line sweeps with full multigrid. A time step is always solved by Newton's method.",
            "paper, section 2: line sweeps with multigrid; ours: newton"),
        number("film.tolerance", "residual tolerance", "", noUnit, between(1e-13, 1e-2),
               at(&Case::film, &FilmCase::tolerance), withFilm,
               "Residual at which the film of a static state, or at the start of a run, counts as solved: the net mass "
               "flow of the cells, summed, relative to the flow through the film. In time steps the accuracy follows "
               "from run.step_error.",
               "ours"),
        integer("film.maximum_iterations", "most iterations", between(1, 10000),
                at(&Case::film, &FilmCase::maximumIterations), withFilm,
                "Iterations on one grid after which the film of a static state counts as not converged.", "ours"),
        choice(
            "film.motion", "film in a run", {"full", "linear"}, at(&Case::film, &FilmCase::motion), withFilm,
            "What a run takes for the film: full = its equations on the grid, solved in each step; linear = its answer "
            "to small motions about the static state, a few dozen equations instead of the grid's thousands. Contact, "
            "friction and suspension are the same in both.",
            "ours: full"),
        number("film.linear_limit", "limit of the linear film", "", noUnit, between(0.0, 10.0),
               at(&Case::film, &FilmCase::linearLimit), withLinearFilm,
               "Error of the slider's displacement by the linear film, as estimated from the motion, against the "
               "displacement, at which a run ends.",
               "ours: 10 %"),
        choice("film.coupling", "coupling", {"monolithic", "staggered"}, at(&Case::film, &FilmCase::coupling),
               withFullFilm,
               "How film and slider are solved together in a time step: monolithic = one Newton's method for pressure "
               "and attitude, staggered = film and slider alternate until neither changes. Both solve the same "
               "equations; staggered needs short steps.",
               "paper, section 2: staggered; ours: monolithic"),
    };
}

std::vector<Parameter> steadyParameters()
{
    return {
        boolean("steady.fixed_attitude", "fixed attitude", at(&Case::steady, &SteadyCase::fixedAttitude), withFilm,
                "Whether the film is solved at the initial attitude only; false = the attitude is found at which the "
                "film carries the load. A fixed attitude with rails inside the disk is refused, unless the case has a "
                "contact law: then the film is solved there with a gap of 0.3 nm.",
                "ours: the slider flies"),
        boolean("steady.stiffness", "stiffness matrix", at(&Case::steady, &SteadyCase::stiffness), withFilm,
                "Whether the stiffness matrix of the film is computed.", "ours"),
        boolean("steady.sensitivities", "sensitivities", at(&Case::steady, &SteadyCase::sensitivities),
                withFreeAttitude,
                "Whether the sensitivities of the attitude to the continuous parameters are computed.", "ours"),
        boolean("steady.all_equilibria", "all equilibria", at(&Case::steady, &SteadyCase::allEquilibria),
                withFreeAttitude, "Whether the program searches for more than one equilibrium attitude.", "ours"),
        number("steady.load_tolerance", "load tolerance", "", noUnit, between(1e-12, 1e-1),
               at(&Case::steady, &SteadyCase::loadTolerance), withFreeAttitude,
               "Residual at which the attitude counts as found: |dF| + |dT_pitch|/L + |dT_roll|/L relative to the "
               "preload; without a preload, relative to 1/1000 of ambient pressure times area.",
               "ours"),
        number("steady.shear_arm", "arm of the air shear", "", noUnit, notNegative(1),
               at(&Case::steady, &SteadyCase::shearArm), withFilm,
               "Arm of the air's shear force about the pivot, in thicknesses of the slider; the established static "
               "program uses 1.",
               "geometry: the mass centre is at half the thickness"),
        number("steady.torque_sign", "sign of the shear torque", "", noUnit, within(1),
               at(&Case::steady, &SteadyCase::torqueSign), withFilm,
               "Factor on the torques of the air's shear: 1 = its pitch torque presses the nose down, -1 = up, 0 = the "
               "torques are omitted.",
               "geometry"),
        list("steady.radii", "radii of a series", millimetres, positive(1), atMost(longestSeries),
             at(&Case::steady, &SteadyCase::radii), withFilm,
             "Radii of a series of static states; empty = disk.radius only.", oneState),
        list("steady.skews", "skews of a series", degrees, within(1.5), atMost(longestSeries),
             at(&Case::steady, &SteadyCase::skews), withFilm,
             "Skews of a series, one for each of steady.radii; empty = disk.skew for all of them.", oneState),
        list("steady.speeds", "speeds of a series", turnsPerMinute, notNegative(1e5), atMost(longestSeries),
             at(&Case::steady, &SteadyCase::speeds), withFilm, "Disk speeds of a series; empty = disk.speed only.",
             oneState),
        list("steady.altitudes", "altitudes of a series", metres, between(-1000, 20000), atMost(longestSeries),
             at(&Case::steady, &SteadyCase::altitudes), withFilm,
             "Altitudes of a series, each with the air of the standard atmosphere at air.temperature; empty = the air "
             "of [air].",
             oneState),
    };
}

} // namespace touchdown
