// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pad of the model "contact", and how it moves; the size of a pad with asperities under a flying slider.
#include "core/case/parameter_builders.h"

namespace touchdown {

using namespace parameter_builders;

namespace {

constexpr double longestPatch = 1e-2; // [m]

bool withPatch(const Case& c) { return withPadSurfaces(c) && c.pad.shape != PadShape::Slider; }
/// The statistical laws use only the size of the pad.
bool withSize(const Case& c) { return withPatch(c) || withAsperityPad(c); }
bool withSphere(const Case& c) { return withPadSurfaces(c) && c.pad.shape == PadShape::Sphere; }

} // namespace

std::vector<Parameter> padParameters()
{
    return {
        choice("pad.shape", "shape", {"flat", "sphere", "slider"}, at(&Case::pad, &PadCase::shape), withPadSurfaces,
               "Shape of the pad: flat = a flat rectangle, sphere = a paraboloid of pad.radius, slider = the pads of "
               "the slider's air bearing surface at initial.pitch and initial.roll.",
               "ours: flat"),
        number("pad.length", "length", "", micrometres, positive(longestPatch), at(&Case::pad, &PadCase::length),
               withSize, "Length of the pad along the motion; for a sphere, length of the computed patch.",
               "assumed: the paper's pads are given in drawings that are lost"),
        number("pad.width", "width", "", micrometres, positive(longestPatch), at(&Case::pad, &PadCase::width), withSize,
               "Width of the pad across the motion; for a sphere, width of the computed patch.",
               "assumed: the paper's pads are given in drawings that are lost"),
        number("pad.radius", "radius", "R", millimetres, positive(1e3), at(&Case::pad, &PadCase::radius), withSphere,
               "Radius of the sphere at its lowest point; the pad is the paraboloid r^2/(2 R).", "ours"),
        number("approach.start", "start", "", nanometres, within(1e-3), at(&Case::approach, &ApproachCase::start),
               withContactModel,
               "Separation at which the pad starts and to which it returns, from the disk's mean plane to the pad's "
               "lowest point.",
               "ours"),
        number("approach.closest", "closest", "", nanometres, within(1e-3), at(&Case::approach, &ApproachCase::closest),
               withContactModel,
               "Smallest separation, reached half way through run.duration; less than approach.start, negative if the "
               "undeformed pad would reach below the mean plane.",
               "ours"),
    };
}

} // namespace touchdown
