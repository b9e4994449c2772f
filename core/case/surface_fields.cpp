// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of the air bearing surface. Its rails, walls and points of interest are tables and lists of a case file:
// see core/case_files/surface_text.h.
#include "core/case/field_builders.h"

namespace touchdown {

using namespace field_builders;

namespace {

constexpr const char* flat = "ours: a flat surface";

} // namespace

std::vector<Field> surfaceFields()
{
    return {
        number({.key = "abs.base_recess",
                .label = "base recess",
                .unit = "m",
                .displayUnit = "um",
                .minimum = -0.001,
                .maximum = 0.001,
                .help = "Recess where there is no rail, from the zero plane and positive away from the disk.",
                .source = "a typical etch depth"},
               at(&Case::surface, &AirBearingSurface::baseRecess), withSliderSurface),
        number({.key = "abs.crown",
                .label = "crown",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = -0.001,
                .maximum = 0.001,
                .help = "Height of the surface's curve along the length, positive when the middle is nearer to the "
                        "disk than leading and "
                        "trailing edge.",
                .source = flat},
               at(&Case::surface, &AirBearingSurface::crown), withSliderSurface),
        number({.key = "abs.camber",
                .label = "camber",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = -0.001,
                .maximum = 0.001,
                .help = "Height of the surface's curve across the width, positive when the middle is nearer to the "
                        "disk than the sides.",
                .source = flat},
               at(&Case::surface, &AirBearingSurface::camber), withSliderSurface),
        number({.key = "abs.twist",
                .label = "twist",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = -0.001,
                .maximum = 0.001,
                .help = "Height of the surface's twist: the outer trailing and the inner leading corner come nearer to "
                        "the disk by this, the "
                        "other two go away.",
                .source = flat},
               at(&Case::surface, &AirBearingSurface::twist), withSliderSurface),
        number({.key = "abs.taper_length",
                .label = "taper length",
                .unit = "m",
                .displayUnit = "mm",
                .minimum = 0,
                .maximum = 0.1,
                .help = "Length of the taper at the leading edge; zero for none.",
                .source = "ours: no taper"},
               at(&Case::surface, &AirBearingSurface::taperLength), withSliderSurface),
        number(
            {.key = "abs.taper_angle",
             .label = "taper angle",
             .unit = "rad",
             .displayUnit = "mrad",
             .minimum = 0,
             .maximum = 1,
             .help =
                 "Angle of the taper: at a distance x from the leading edge the recess is at least angle (length - x).",
             .source = "ours: no taper"},
            at(&Case::surface, &AirBearingSurface::taperAngle), withSliderSurface),
    };
}

} // namespace touchdown
