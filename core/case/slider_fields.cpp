// SPDX-License-Identifier: GPL-3.0-or-later
//
// The slider as a rigid body.
#include "core/case/field_builders.h"

namespace touchdown {

using namespace field_builders;

namespace {

constexpr const char* typicalPico = "assumed: Table II of the paper is lost; a typical pico slider";

bool withThickness(const Case& c) { return withFilm(c) || withContactModel(c) || (withSprings(c) && withOnoYamane(c)); }

} // namespace

std::vector<Field> sliderFields()
{
    return {
        number({.key = "slider.length",
                .label = "length",
                .symbol = "L",
                .unit = "m",
                .displayUnit = "mm",
                .minimum = 0,
                .maximum = 0.1,
                .minimumAllowed = false,
                .help = "Length of the slider, from the leading to the trailing edge.",
                .source = "a pico slider, 1.25 mm"},
               at(&Case::slider, &SliderCase::length), withSliderSurface),
        number({.key = "slider.width",
                .label = "width",
                .symbol = "W",
                .unit = "m",
                .displayUnit = "mm",
                .minimum = 0,
                .maximum = 0.1,
                .minimumAllowed = false,
                .help = "Width of the slider, from the inner to the outer edge.",
                .source = "a pico slider, 1.00 mm"},
               at(&Case::slider, &SliderCase::width), withSliderSurface),
        number({.key = "slider.thickness",
                .label = "thickness",
                .symbol = "b",
                .unit = "m",
                .displayUnit = "mm",
                .minimum = 0,
                .maximum = 1,
                .help = "Thickness of the slider; friction acts half of it below the mass centre, and the air's shear "
                        "steady.shear_arm of it below the pivot.",
                .source = typicalPico},
               at(&Case::slider, &SliderCase::thickness), withThickness),
        number({.key = "slider.mass",
                .label = "mass",
                .symbol = "M",
                .unit = "kg",
                .displayUnit = "mg",
                .minimum = 0,
                .maximum = 10,
                .minimumAllowed = false,
                .help = "Mass of the slider.",
                .source = typicalPico},
               at(&Case::slider, &SliderCase::mass), withBearing),
        number({.key = "slider.pitch_inertia",
                .label = "pitch inertia",
                .symbol = "J",
                .unit = "kg m^2",
                .displayUnit = "kg m^2",
                .minimum = 0,
                .maximum = 10,
                .minimumAllowed = false,
                .help = "Moment of inertia of the slider about its pitch axis through the mass centre.",
                .source = typicalPico},
               at(&Case::slider, &SliderCase::pitchInertia), withBearing),
        number({.key = "slider.roll_inertia",
                .label = "roll inertia",
                .unit = "kg m^2",
                .displayUnit = "kg m^2",
                .minimum = 0,
                .maximum = 10,
                .minimumAllowed = false,
                .help = "Moment of inertia of the slider about its roll axis through the mass centre.",
                .source = "a typical pico slider"},
               at(&Case::slider, &SliderCase::rollInertia), withFilm),
    };
}

} // namespace touchdown
