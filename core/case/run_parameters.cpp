// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a run starts, how it is integrated, and how its spectra are estimated.
#include "core/case/parameter_builders.h"

namespace touchdown {

using namespace parameter_builders;

namespace {

constexpr double longestRun = 100.0; // [s]
constexpr int mostSnapshots = 10000;
constexpr int mostThreads = 32;

bool withPitch(const Case& c) { return withBearing(c) || withSliderPad(c); }
bool withOffsets(const Case& c) { return withFilm(c) && c.initial.state == InitialState::Static; }
bool withRollOffset(const Case& c) { return withOffsets(c) && withRoll(c); }
/// The gap and the pressure of the film, and those of a contact patch.
/// A law with branches, or a slider that may fly and touch.
bool withSeveralStates(const Case& c) { return withOnoYamane(c) || (withFilm(c) && c.contact != noContact); }
bool withSnapshots(const Case& c) { return withFilm(c) ? c.film.motion == FilmMotion::Full : withSurfaces(c); }

} // namespace

std::vector<Parameter> runParameters()
{
    return {
        number("initial.flying_height", "initial flying height", "FH(0)", nanometres, within(1),
               at(&Case::initial, &InitialCase::flyingHeight), withSprings,
               "Flying height at the contact pad at the start.", "paper, text on Fig. 10: 250 nm"),
        choice("initial.state", "initial state", {"given", "static"}, at(&Case::initial, &InitialCase::state), withFilm,
               "Where a run starts: given = at the initial attitude, static = at the computed static attitude plus the "
               "offsets.",
               "ours: the initial attitude"),
        number("initial.height_offset", "height offset", "", nanometres, within(1e-3),
               at(&Case::initial, &InitialCase::heightOffset), withOffsets,
               "Initial height of the mass centre above its height in the static state.", none),
        number("initial.pitch_offset", "pitch offset", "", microradians, within(1),
               at(&Case::initial, &InitialCase::pitchOffset), withOffsets,
               "Initial pitch minus the pitch of the static state; the slider is turned about its mass centre.", none),
        number("initial.roll_offset", "roll offset", "", microradians, within(1),
               at(&Case::initial, &InitialCase::rollOffset), withRollOffset,
               "Initial roll minus the roll of the static state; the slider is turned about its mass centre.", none),
        number("initial.nominal_trailing_edge_height", "initial trailing edge height", "", nanometres, within(1e-3),
               at(&Case::initial, &InitialCase::nominalTrailingEdgeHeight), withFilm,
               "Initial height of the middle of the trailing edge, at recess 0; may be negative if the edge is "
               "recessed. The search for the static attitude starts there, too.",
               "ours"),
        number("initial.pitch", "initial pitch", "theta(0)", microradians, within(1),
               at(&Case::initial, &InitialCase::pitch), withPitch, "Pitch angle at the start, leading edge up.",
               "paper, text on Fig. 10: 0 urad"),
        number("initial.roll", "initial roll", "", microradians, within(1), at(&Case::initial, &InitialCase::roll),
               withSliderSurface, "Roll angle at the start, inner edge up; constant with two degrees of freedom.",
               "ours: none"),
        number("initial.vertical_velocity", "initial vertical velocity", "", {"m/s", "mm/s"}, anyNumber,
               at(&Case::initial, &InitialCase::verticalVelocity), withBearing,
               "Velocity of the mass centre at the start, positive away from the disk.",
               "assumed: at rest; the paper does not say"),
        number("initial.pitch_velocity", "initial pitch velocity", "", {"rad/s", "rad/s"}, anyNumber,
               at(&Case::initial, &InitialCase::pitchVelocity), withBearing,
               "Pitch velocity at the start, positive when the leading edge rises.",
               "assumed: at rest; the paper does not say"),
        number("initial.roll_velocity", "initial roll velocity", "", {"rad/s", "rad/s"}, anyNumber,
               at(&Case::initial, &InitialCase::rollVelocity), withRoll,
               "Roll velocity at the start, positive when the inner edge rises.",
               "assumed: at rest; the paper does not say"),
        choice("initial.branch", "initial branch", {"touch-down", "take-off"}, at(&Case::initial, &InitialCase::branch),
               withSeveralStates,
               "Branch of the contact characteristic at the start, if the separation is between d_s and d_e. Of a film "
               "with a contact it also chooses the static state where there are several: touch-down = flying, if it "
               "can, take-off = in contact. Under elastic contact with attraction other states are sought with "
               "take-off only, "
               "as that takes long.",
               "paper, section 4: touch-down"),
        number("run.duration", "duration", "", milliseconds, positive(longestRun), at(&Case::run, &RunCase::duration),
               always, "Simulated time.", "paper, Figs. 10-14: 2 ms"),
        choice("run.integrator", "integrator", {"rk4", "rk4-events", "newmark", "dopri5", "cvode"},
               at(&Case::run, &RunCase::integrator), withSprings,
               "rk4 = fixed step, switches detected once per step as in the paper; rk4-events = fixed step, switches "
               "located; newmark = implicit, fixed step; dopri5 = adaptive, switches located; cvode = SUNDIALS, for "
               "comparison.",
               "paper: 4th-order Runge-Kutta for this model; dopri5: Dormand & Prince 1980"),
        choice("run.steps", "time steps", {"adaptive", "fixed"}, at(&Case::run, &RunCase::steps), withFilm,
               "Length of the time steps of film and slider: adaptive = as run.step_error allows, fixed = run.step.",
               "ours: adaptive"),
        number("run.step", "time step", "", nanoseconds, positive(longestRun), at(&Case::run, &RunCase::step),
               withFixedStep, "Length of a fixed time step.", "paper, text on Table III: 1e-8 and 1e-9 s"),
        number("run.step_error", "step error", "", nanometres, between(1e-18, 1e-6),
               at(&Case::run, &RunCase::stepError), withFilm,
               "Limits the error of a single step, as a displacement of the slider; sets the length of adaptive steps "
               "and the accuracy to which each step is solved. Errors accumulate over the run.",
               "ours"),
        number("run.tolerance", "tolerance", "", noUnit, between(1e-14, 1e-2), at(&Case::run, &RunCase::tolerance),
               withAdaptiveSpringStep,
               "Local error allowed per step of the adaptive integrators, relative to the scale of the static state.",
               "ours"),
        number("run.newmark_beta", "Newmark beta", "beta", noUnit, positive(1), at(&Case::run, &RunCase::newmarkBeta),
               withNewmark,
               "Weight of the new acceleration in the displacement; 2 beta >= gamma >= 1/2 is unconditionally stable "
               "for linear systems.",
               "Newmark 1959: 1/4, the average acceleration"),
        number("run.newmark_gamma", "Newmark gamma", "gamma", noUnit, between(0.5, 1),
               at(&Case::run, &RunCase::newmarkGamma), withNewmark,
               "Weight of the new acceleration in the velocity; above 1/2 it damps and is of first order.",
               "Newmark 1959: 1/2, no numerical damping"),
        number("run.sample_interval", "sample interval", "", microseconds, positive(longestRun),
               at(&Case::run, &RunCase::sampleInterval), always,
               "Time between recorded samples. The last sample is at the end of the run.", "ours"),
        boolean("run.step_check", "step check", at(&Case::run, &RunCase::stepCheck), withStepCheck,
                "Whether a fixed-step run is repeated with half the step, to report a different end state. An adaptive "
                "run that touches a moving surface is repeated with a hundredth of the tolerance, to report another "
                "motion.",
                "paper, text on Table III: convergence between two steps"),
        integer("run.field_snapshots", "field snapshots", notNegative(mostSnapshots),
                at(&Case::run, &RunCase::fieldSnapshots), withSnapshots,
                "Number of snapshots of the fields of the film and of the contact patch, evenly spaced over the run; 0 "
                "= none. For a pad, the fields at the closest approach are always among them.",
                "ours"),
        integer("run.threads", "threads", notNegative(mostThreads), at(&Case::run, &RunCase::threads), withFilm,
                "Threads on which a film is computed; 0 = as many as are worth it: at most 8, the number of cores, or "
                "the part of them that a study leaves to each of its items. Results do not depend on it.",
                "ours"),
        choice("spectrum.window", "window", {"rectangular", "hann", "hamming", "blackman", "flat-top"},
               at(&Case::spectrum, &SpectrumCase::window), withBearing, "Window on each segment of the signal.",
               "Welch 1967; Harris 1978"),
        choice(
            "spectrum.scaling", "scaling", {"density", "amplitude"}, at(&Case::spectrum, &SpectrumCase::scaling),
            withBearing,
            "density = the integral over frequency is the mean square; amplitude = a sine of amplitude A shows A^2/2.",
            "Welch 1967"),
        number("spectrum.segment", "segment", "", microseconds, positive(longestRun),
               at(&Case::spectrum, &SpectrumCase::segment), withBearing,
               "Length of one segment; longer resolves finer, shorter averages more.", "ours"),
        number("spectrum.overlap", "overlap", "", noUnit, notNegative(0.95),
               at(&Case::spectrum, &SpectrumCase::overlap), withBearing, "Fraction that neighbouring segments share.",
               "Welch 1967: one half"),
        number("spectrum.start", "start", "", milliseconds, notNegative(longestRun),
               at(&Case::spectrum, &SpectrumCase::start), withBearing, "Samples before this time are not used.",
               "ours"),
    };
}

} // namespace touchdown
