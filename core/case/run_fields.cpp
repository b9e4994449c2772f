// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a run starts, how it is integrated, and how its spectra are estimated.
#include "core/case/field_builders.h"

namespace touchdown {

using namespace field_builders;

namespace {

constexpr double longestRun = 100.0; // [s]
constexpr int mostSnapshots = 10000;
constexpr const char* none = "ours: none";

bool withPitch(const Case& c) { return withBearing(c) || withSliderPad(c); }
bool withOffsets(const Case& c) { return withFilm(c) && c.initial.state == InitialState::Static; }
bool withRollOffset(const Case& c) { return withOffsets(c) && withRoll(c); }
/// The gap and the pressure of the film, and those of a contact patch.
bool withSnapshots(const Case& c) { return withFilm(c) || withSurfaces(c); }

std::vector<Field> initialFields()
{
    return {
        number({.key = "initial.flying_height",
                .label = "initial flying height",
                .symbol = "FH(0)",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = -1,
                .maximum = 1,
                .help = "Flying height at the contact pad at the start.",
                .source = "paper, text on Fig. 10: 250 nm"},
               at(&Case::initial, &InitialCase::flyingHeight), withSprings),
        choice({.key = "initial.state",
                .label = "initial state",
                .choices = {"given", "static"},
                .help = "Where a run starts: given = at the initial attitude, static = at the static attitude, which "
                        "is computed "
                        "first, moved by the offsets.",
                .source = "ours: the initial attitude"},
               at(&Case::initial, &InitialCase::state), withFilm),
        number({.key = "initial.height_offset",
                .label = "height offset",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = -1e-3,
                .maximum = 1e-3,
                .help = "How far the mass centre starts above the static state.",
                .source = none},
               at(&Case::initial, &InitialCase::heightOffset), withOffsets),
        number(
            {.key = "initial.pitch_offset",
             .label = "pitch offset",
             .unit = "rad",
             .displayUnit = "urad",
             .minimum = -1,
             .maximum = 1,
             .help = "By how much the slider starts with more pitch than in the static state; about the mass centre.",
             .source = none},
            at(&Case::initial, &InitialCase::pitchOffset), withOffsets),
        number({.key = "initial.roll_offset",
                .label = "roll offset",
                .unit = "rad",
                .displayUnit = "urad",
                .minimum = -1,
                .maximum = 1,
                .help = "By how much the slider starts with more roll than in the static state; about the mass centre.",
                .source = none},
               at(&Case::initial, &InitialCase::rollOffset), withRollOffset),
        number({.key = "initial.nominal_trailing_edge_height",
                .label = "initial trailing edge height",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = -1e-3,
                .maximum = 1e-3,
                .help = "Height of the middle of the trailing edge, at recess 0, at the start; may be negative where "
                        "the edge is "
                        "recessed. The search for the static attitude begins there, too.",
                .source = "ours"},
               at(&Case::initial, &InitialCase::nominalTrailingEdgeHeight), withFilm),
        number({.key = "initial.pitch",
                .label = "initial pitch",
                .symbol = "theta(0)",
                .unit = "rad",
                .displayUnit = "urad",
                .minimum = -1,
                .maximum = 1,
                .help = "Pitch angle at the start, leading edge up.",
                .source = "paper, text on Fig. 10: 0 urad"},
               at(&Case::initial, &InitialCase::pitch), withPitch),
        number({.key = "initial.roll",
                .label = "initial roll",
                .unit = "rad",
                .displayUnit = "urad",
                .minimum = -1,
                .maximum = 1,
                .help = "Roll angle at the start, inner edge up; held where there are two degrees of freedom.",
                .source = "ours: none"},
               at(&Case::initial, &InitialCase::roll), withSliderSurface),
        number({.key = "initial.vertical_velocity",
                .label = "initial vertical velocity",
                .unit = "m/s",
                .displayUnit = "mm/s",
                .help = "Velocity of the mass centre at the start, positive away from the disk.",
                .source = "assumed: at rest; the paper does not say"},
               at(&Case::initial, &InitialCase::verticalVelocity), withBearing),
        number({.key = "initial.pitch_velocity",
                .label = "initial pitch velocity",
                .unit = "rad/s",
                .displayUnit = "rad/s",
                .help = "Pitch velocity at the start, positive when the leading edge rises.",
                .source = "assumed: at rest; the paper does not say"},
               at(&Case::initial, &InitialCase::pitchVelocity), withBearing),
        number({.key = "initial.roll_velocity",
                .label = "initial roll velocity",
                .unit = "rad/s",
                .displayUnit = "rad/s",
                .help = "Roll velocity at the start, positive when the inner edge rises.",
                .source = "assumed: at rest; the paper does not say"},
               at(&Case::initial, &InitialCase::rollVelocity), withRoll),
        choice({.key = "initial.branch",
                .label = "initial branch",
                .choices = {"touch-down", "take-off"},
                .help = "Branch of the contact characteristic at the start, where that is between d_s and d_e.",
                .source = "paper, section 4: touch-down"},
               at(&Case::initial, &InitialCase::branch), withOnoYamane),
    };
}

std::vector<Field> integrationFields()
{
    return {
        number({.key = "run.duration",
                .label = "duration",
                .unit = "s",
                .displayUnit = "ms",
                .minimum = 0,
                .maximum = longestRun,
                .minimumAllowed = false,
                .help = "Simulated time.",
                .source = "paper, Figs. 10-14: 2 ms"},
               at(&Case::run, &RunCase::duration)),
        choice(
            {.key = "run.integrator",
             .label = "integrator",
             .choices = {"rk4", "rk4-events", "newmark", "dopri5", "cvode"},
             .help =
                 "rk4 = fixed step, switches seen once per step as in the paper; rk4-events = fixed step, switches "
                 "located; newmark = implicit, fixed step; dopri5 = adaptive, switches located; cvode = SUNDIALS, for "
                 "comparison.",
             .source = "paper: 4th-order Runge-Kutta for this model; dopri5: Dormand & Prince 1980"},
            at(&Case::run, &RunCase::integrator), withSprings),
        choice(
            {.key = "run.steps",
             .label = "time steps",
             .choices = {"adaptive", "fixed"},
             .help =
                 "How long a time step of film and slider is: adaptive = as run.step_error allows, fixed = run.step.",
             .source = "ours: adaptive"},
            at(&Case::run, &RunCase::steps), withFilm),
        number({.key = "run.step",
                .label = "time step",
                .unit = "s",
                .displayUnit = "ns",
                .minimum = 0,
                .maximum = longestRun,
                .minimumAllowed = false,
                .help = "Time step where it is fixed.",
                .source = "paper, text on Table III: 1e-8 and 1e-9 s"},
               at(&Case::run, &RunCase::step), withFixedStep),
        number({.key = "run.step_error",
                .label = "step error",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = 1e-18,
                .maximum = 1e-6,
                .help = "By which one time step's discretisation may displace the slider; sets how long adaptive steps "
                        "are, and how "
                        "far every step is solved.",
                .source = "ours"},
               at(&Case::run, &RunCase::stepError), withFilm),
        number(
            {.key = "run.tolerance",
             .label = "tolerance",
             .minimum = 1e-14,
             .maximum = 1e-2,
             .help =
                 "Local error allowed per step of the adaptive integrators, relative to the scale of the static state.",
             .source = "ours"},
            at(&Case::run, &RunCase::tolerance), withAdaptiveSpringStep),
        number({.key = "run.newmark_beta",
                .label = "Newmark beta",
                .symbol = "beta",
                .minimum = 0,
                .maximum = 1,
                .minimumAllowed = false,
                .help = "Weight of the new acceleration in the displacement; 2 beta >= gamma >= 1/2 is unconditionally "
                        "stable for "
                        "linear systems.",
                .source = "Newmark 1959: 1/4, the average acceleration"},
               at(&Case::run, &RunCase::newmarkBeta), withNewmark),
        number({.key = "run.newmark_gamma",
                .label = "Newmark gamma",
                .symbol = "gamma",
                .minimum = 0.5,
                .maximum = 1,
                .help = "Weight of the new acceleration in the velocity; above 1/2 it damps and is of first order.",
                .source = "Newmark 1959: 1/2, no numerical damping"},
               at(&Case::run, &RunCase::newmarkGamma), withNewmark),
        number({.key = "run.sample_interval",
                .label = "sample interval",
                .unit = "s",
                .displayUnit = "us",
                .minimum = 0,
                .maximum = longestRun,
                .minimumAllowed = false,
                .help = "Time between recorded samples.",
                .source = "ours"},
               at(&Case::run, &RunCase::sampleInterval)),
        plain(FieldKind::Boolean,
              {.key = "run.step_check",
               .label = "step check",
               .help = "Whether a fixed-step run is repeated with half the step, to report a different end state.",
               .source = "paper, text on Table III: convergence between two steps"},
              at(&Case::run, &RunCase::stepCheck), withFixedSpringStep),
        plain(FieldKind::Integer,
              {.key = "run.field_snapshots",
               .label = "field snapshots",
               .minimum = 0,
               .maximum = mostSnapshots,
               .help = "How often the fields of the film and over the contact patch are recorded, evenly over the run; "
                       "a pad's at the "
                       "closest approach are recorded in any case, unless this is 0.",
               .source = "ours"},
              at(&Case::run, &RunCase::fieldSnapshots), withSnapshots),
    };
}

std::vector<Field> spectrumFields()
{
    return {
        choice({.key = "spectrum.window",
                .label = "window",
                .choices = {"rectangular", "hann", "hamming", "blackman", "flat-top"},
                .help = "Window on each segment of the signal.",
                .source = "Welch 1967; Harris 1978"},
               at(&Case::spectrum, &SpectrumCase::window), withBearing),
        choice({.key = "spectrum.scaling",
                .label = "scaling",
                .choices = {"density", "amplitude"},
                .help = "density = the integral over frequency is the mean square; amplitude = a sine of amplitude A "
                        "shows A^2/2.",
                .source = "Welch 1967"},
               at(&Case::spectrum, &SpectrumCase::scaling), withBearing),
        number({.key = "spectrum.segment",
                .label = "segment",
                .unit = "s",
                .displayUnit = "us",
                .minimum = 0,
                .maximum = longestRun,
                .minimumAllowed = false,
                .help = "Length of one segment; longer resolves finer, shorter averages more.",
                .source = "ours"},
               at(&Case::spectrum, &SpectrumCase::segment), withBearing),
        number({.key = "spectrum.overlap",
                .label = "overlap",
                .minimum = 0,
                .maximum = 0.95,
                .help = "Part that neighbouring segments share.",
                .source = "Welch 1967: one half"},
               at(&Case::spectrum, &SpectrumCase::overlap), withBearing),
        number({.key = "spectrum.start",
                .label = "start",
                .unit = "s",
                .displayUnit = "ms",
                .minimum = 0,
                .maximum = longestRun,
                .help = "Time before which the spectrum takes nothing.",
                .source = "ours"},
               at(&Case::spectrum, &SpectrumCase::start), withBearing),
    };
}

} // namespace

std::vector<Field> runFields()
{
    std::vector<Field> all = initialFields();
    for (auto part : {integrationFields, spectrumFields})
        for (Field& field : part()) all.push_back(std::move(field));
    return all;
}

} // namespace touchdown
