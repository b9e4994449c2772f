// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of the air bearing surface. Its rails, walls and points of interest are tables and lists of a case file:
// see core/case_files/surface_text.h.
#include "core/case/parameter_builders.h"

namespace touchdown {

using namespace parameter_builders;

namespace {

constexpr const char* flat = "ours: a flat surface";

} // namespace

std::vector<Parameter> surfaceParameters()
{
    return {
        number("abs.base_recess", "base recess", "", micrometres, within(1e-3),
               at(&Case::surface, &AirBearingSurface::baseRecess), withSliderSurface,
               "Recess outside the rails, from the zero plane and positive away from the disk.",
               "a typical etch depth"),
        number("abs.crown", "crown", "", nanometres, within(1e-3), at(&Case::surface, &AirBearingSurface::crown),
               withSliderSurface,
               "Height of the surface's curvature along the length, positive when the middle is nearer to the disk "
               "than the leading and trailing edges.",
               flat),
        number("abs.camber", "camber", "", nanometres, within(1e-3), at(&Case::surface, &AirBearingSurface::camber),
               withSliderSurface,
               "Height of the surface's curvature across the width, positive when the middle is nearer to the disk "
               "than the sides.",
               flat),
        number("abs.twist", "twist", "", nanometres, within(1e-3), at(&Case::surface, &AirBearingSurface::twist),
               withSliderSurface,
               "Height of the surface's twist: the outer trailing and the inner leading corner are nearer to the disk "
               "by this height, the other two corners are farther away.",
               flat),
        number("abs.taper_length", "taper length", "", millimetres, notNegative(0.1),
               at(&Case::surface, &AirBearingSurface::taperLength), withSliderSurface,
               "Length of the taper at the leading edge; zero for none.", "ours: no taper"),
        number("abs.taper_angle", "taper angle", "", milliradians, notNegative(1),
               at(&Case::surface, &AirBearingSurface::taperAngle), withSliderSurface,
               "Angle of the taper: at a distance x from the leading edge the recess is at least angle (length - x).",
               "ours: no taper"),
    };
}

} // namespace touchdown
