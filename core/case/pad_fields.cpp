// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pad of the model "contact", and how it moves.
#include "core/case/field_builders.h"

namespace touchdown {

using namespace field_builders;

namespace {

constexpr double longestPatch = 1e-2; // [m]

bool withPatch(const Case& c) { return withPadSurfaces(c) && c.pad.shape != PadShape::Slider; }
/// The statistical laws know the size of the pad alone.
bool withSize(const Case& c) { return withPatch(c) || withAsperities(c); }
bool withSphere(const Case& c) { return withPadSurfaces(c) && c.pad.shape == PadShape::Sphere; }

} // namespace

std::vector<Field> padFields()
{
    return {
        choice(
            {.key = "pad.shape",
             .label = "shape",
             .choices = {"flat", "sphere", "slider"},
             .help =
                 "Shape of the pad that meets the disk: flat = a flat rectangle, sphere = a paraboloid of pad.radius, "
                 "slider = the pads of the slider's air bearing surface at initial.pitch and initial.roll.",
             .source = "ours: flat"},
            at(&Case::pad, &PadCase::shape), withPadSurfaces),
        number({.key = "pad.length",
                .label = "length",
                .unit = "m",
                .displayUnit = "um",
                .minimum = 0,
                .maximum = longestPatch,
                .minimumAllowed = false,
                .help = "Length of the pad along the motion; of the patch that is solved where the pad is a sphere.",
                .source = "assumed: the paper's pads are given in drawings that are lost"},
               at(&Case::pad, &PadCase::length), withSize),
        number({.key = "pad.width",
                .label = "width",
                .unit = "m",
                .displayUnit = "um",
                .minimum = 0,
                .maximum = longestPatch,
                .minimumAllowed = false,
                .help = "Width of the pad across the motion; of the patch that is solved where the pad is a sphere.",
                .source = "assumed: the paper's pads are given in drawings that are lost"},
               at(&Case::pad, &PadCase::width), withSize),
        number({.key = "pad.radius",
                .label = "radius",
                .symbol = "R",
                .unit = "m",
                .displayUnit = "mm",
                .minimum = 0,
                .maximum = 1e3,
                .minimumAllowed = false,
                .help = "Radius of the sphere at its lowest point; the pad is the paraboloid r^2/(2 R).",
                .source = "ours"},
               at(&Case::pad, &PadCase::radius), withSphere),
        number(
            {.key = "approach.start",
             .label = "start",
             .unit = "m",
             .displayUnit = "nm",
             .minimum = -1e-3,
             .maximum = 1e-3,
             .help =
                 "Separation at which the pad starts and to which it returns, from the disk's mean plane to the pad's "
                 "lowest point.",
             .source = "ours"},
            at(&Case::approach, &ApproachCase::start), withContactModel),
        number({.key = "approach.closest",
                .label = "closest",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = -1e-3,
                .maximum = 1e-3,
                .help =
                    "Separation at which the pad turns round, half way through run.duration; less than approach.start, "
                    "negative where the undeformed pad would reach below the mean plane.",
                .source = "ours"},
               at(&Case::approach, &ApproachCase::closest), withContactModel),
    };
}

} // namespace touchdown
