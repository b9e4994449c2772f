// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case/choice_text.h"

#include <algorithm>

#include <QCoreApplication>

#include "core/case/contact_law.h"
#include "core/physics/film/slip.h"

namespace touchdown {

namespace {

struct Row {
    std::string_view key, choice;
    const char *name, *meaning;
};

/// But for laws of contact and slip, which their own rows describe.
constexpr Row rows[]{
    {"model", "springs", "two springs", "Two nonlinear springs and dashpots stand for the air bearing (Ono & Yamane)."},
    {"model", "film", "air film",
     "The film of air under the slider's surface is solved (generalised Reynolds equation)."},
    {"model", "contact", "contact only", "Without air: a pad moves towards the disk and back."},

    {"springs.potential", "held", "constant", "Below d_1 a spring keeps the energy that it has at d_1."},
    {"springs.potential", "as-printed", "as printed",
     "Equation (5) of the paper continues below d_1; the energy can become negative."},

    {"pad.shape", "flat", "flat rectangle", "A flat rectangle."},
    {"pad.shape", "sphere", "sphere", "A paraboloid with the radius of a sphere."},
    {"pad.shape", "slider", "slider's pads",
     "The pads of the slider's air bearing surface at its initial pitch and roll."},

    {"ono_yamane.take_off_shape", "constant", "menisci constant",
     "Between d_s and d_e the menisci pull with f_m; the contact force falls along k_c."},
    {"ono_yamane.take_off_shape", "linear", "menisci fall",
     "The force of the menisci falls to zero at d_e; the contact force falls along k_c."},
    {"ono_yamane.take_off_shape", "both-linear", "both forces fall",
     "The force of the menisci and the contact force fall on straight lines to zero at d_e."},

    {"adhesion.kind", "none", "none", "No intermolecular forces."},
    {"adhesion.kind", "lennard-jones", "Lennard-Jones",
     "Lennard-Jones forces, shifted so that they vanish in contact."},
    {"adhesion.kind", "van-der-waals", "van der Waals", "The classical form with its own repulsion."},

    {"asperity.model", "greenwood-williamson", "elastic",
     "Each summit deforms elastically (Greenwood & Williamson 1966)."},
    {"asperity.model", "elastic-plastic", "elastic-plastic",
     "A summit yields when it is pressed far enough (Chang, Etsion & Bogy 1987)."},

    {"air.source", "given", "values given here", "Pressure, viscosity and mean free path are those below."},
    {"air.source", "atmosphere", "from the altitude", "From altitude and temperature, as in the standard atmosphere."},
    {"air.source", "established-standard", "established",
     "101325 Pa, 1.8372e-5 Pa s and 68.6 nm: the standard air of the established static program."},

    {"disk.velocity_field", "rotating", "rotating",
     "The velocity differs by a few per cent and about two degrees from edge to edge of the slider."},
    {"disk.velocity_field", "uniform", "uniform", "Everywhere the velocity at the slider's centre."},

    {"disk.surface.kind", "flat", "flat", "An ideal plane."},
    {"disk.surface.kind", "waves", "waves", "A sum of sines."},
    {"disk.surface.kind", "rough", "rough", "Random heights of a given spectrum."},
    {"disk.surface.kind", "file", "measured (file)", "A measured profile or map."},
    {"disk.surface.kind", "bumps", "bumps and pits", "Single bumps and pits."},
    {"disk.surface.kind", "combined", "combined", "The sum of all parts that are given."},

    {"disk.surface.motion", "moving", "moving", "The surface moves under the slider."},
    {"disk.surface.motion", "still", "stands still", "The same surface stands still under the slider."},

    {"disk.surface.spectrum", "gaussian", "Gaussian", "The autocorrelation is a Gaussian: smooth hills of one width."},
    {"disk.surface.spectrum", "exponential", "exponential",
     "The autocorrelation is exponential: finer and finer heights."},
    {"disk.surface.spectrum", "self-affine", "self-affine", "A power law between two wavelengths."},

    {"disk.surface.bump_shape", "ellipsoid", "ellipsoid", "The cap of an ellipsoid, with an edge at its base."},
    {"disk.surface.bump_shape", "gaussian", "Gaussian", "A bell curve."},
    {"disk.surface.bump_shape", "cosine", "cosine", "One period of a cosine, smooth at its base."},

    {"film.grid", "uniform", "uniform", "All cells are equal."},
    {"film.grid", "graded", "at rail edges", "Grid lines lie on the edges of the rails."},
    {"film.grid", "adapted", "adapted", "Also denser where the pressure profile bends."},

    {"film.scheme", "upwind", "upwind", "First order: robust and inaccurate (Patankar 1980)."},
    {"film.scheme", "hybrid", "hybrid", "Central where that is stable, upwind elsewhere (Patankar 1980)."},
    {"film.scheme", "power-law", "power law (paper)", "Close to the exact flow between two nodes (Patankar 1980)."},
    {"film.scheme", "exponential", "exponential", "Exact for a plane flow between two nodes."},
    {"film.scheme", "complete-flux", "complete flux", "Second order, whatever part of the flow the disk drags along."},

    {"film.solver", "newton", "Newton", "Newton's method with the exact Jacobian."},
    {"film.solver", "line-multigrid", "multigrid (paper)", "Alternating line sweeps on several grids."},

    {"film.motion", "full", "in each step", "The film's equations are solved on the grid in each step."},
    {"film.motion", "linear", "small motions",
     "The film's answer to small motions about the static state, without the grid."},

    {"film.coupling", "monolithic", "together", "Pressure and attitude are solved at once by one Newton's method."},
    {"film.coupling", "staggered", "in turn (paper)",
     "Film and slider in turn until neither changes; needs short steps."},

    {"initial.state", "given", "as given below", "At the initial height, pitch and roll."},
    {"initial.state", "static", "static and offsets", "At the static attitude, which is computed first, plus offsets."},

    {"initial.branch", "touch-down", "touch-down", "The slider comes from above: no menisci yet."},
    {"initial.branch", "take-off", "take-off", "The slider comes from the disk: the menisci still pull."},

    {"run.integrator", "rk4", "Runge-Kutta (paper)", "Fixed step; switches are seen once per step, as in the paper."},
    {"run.integrator", "rk4-events", "Runge-Kutta, events", "Fixed step; switches are located."},
    {"run.integrator", "newmark", "Newmark", "Implicit, fixed step."},
    {"run.integrator", "dopri5", "Dormand-Prince", "Steps as long as the tolerance allows; switches are located."},
    {"run.integrator", "cvode", "CVODE", "The integrator of SUNDIALS, for comparison."},

    {"run.steps", "adaptive", "by their error", "As long as the allowed error of a step."},
    {"run.steps", "fixed", "fixed", "All of one length."},

    {"spectrum.window", "rectangular", "none", "Each segment as it is: narrow peaks, much leakage."},
    {"spectrum.window", "hann", "Hann", "A good choice for most signals."},
    {"spectrum.window", "hamming", "Hamming", "Narrower than Hann, with more leakage far from a peak."},
    {"spectrum.window", "blackman", "Blackman", "Little leakage, wider peaks."},
    {"spectrum.window", "flat-top", "flat top", "Exact heights of peaks, which are wide."},

    {"spectrum.scaling", "density", "density", "The integral over frequency is the mean square."},
    {"spectrum.scaling", "amplitude", "amplitude", "A sine of amplitude A shows A²/2."},
};

} // namespace

ChoiceText choiceText(std::string_view key, std::string_view choice)
{
    const auto tr = [](const char* text) { return QCoreApplication::translate("Choice", text); };
    const auto ofLaw = [&](const auto& laws) -> ChoiceText {
        const auto law = std::ranges::find(laws, choice, [](const auto& each) { return each.name; });
        return law == laws.end() ? ChoiceText{} : ChoiceText{tr(law->label.data()), tr(law->meaning.data())};
    };
    if (key == "contact") return ofLaw(contactLaws());
    if (key == "air.slip") return ofLaw(slipLaws());
    const auto* row =
        std::ranges::find_if(rows, [&](const Row& each) { return each.key == key && each.choice == choice; });
    if (row == std::end(rows)) return {};
    return {tr(row->name), tr(row->meaning)};
}

} // namespace touchdown
