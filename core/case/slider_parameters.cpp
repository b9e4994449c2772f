// SPDX-License-Identifier: GPL-3.0-or-later
//
// The slider as a rigid body.
#include "core/case/parameter_builders.h"

namespace touchdown {

using namespace parameter_builders;

namespace {

constexpr const char* typicalPico = "assumed: Table II of the paper is lost; a typical pico slider";

bool withThickness(const Case& c) { return withFilm(c) || (c.contact != noContact && contactActs(c)); }

} // namespace

std::vector<Parameter> sliderParameters()
{
    return {
        number("slider.length", "length", "L", millimetres, positive(0.1), at(&Case::slider, &SliderCase::length),
               withSliderOutline, "Length of the slider, from the leading to the trailing edge.",
               "a pico slider, 1.25 mm"),
        number("slider.width", "width", "W", millimetres, positive(0.1), at(&Case::slider, &SliderCase::width),
               withSliderOutline, "Width of the slider, from the inner to the outer edge.", "a pico slider, 1.00 mm"),
        number("slider.thickness", "thickness", "b", millimetres, notNegative(1),
               at(&Case::slider, &SliderCase::thickness), withThickness,
               "Thickness of the slider; friction acts half a thickness below the mass centre, the air's shear "
               "steady.shear_arm thicknesses below the pivot.",
               typicalPico),
        number("slider.mass", "mass", "M", {"kg", "mg"}, between(1e-12, 10), at(&Case::slider, &SliderCase::mass),
               withBearing, "Mass of the slider.", typicalPico),
        number("slider.pitch_inertia", "pitch inertia", "J", {"kg m^2", "kg m^2"}, between(1e-21, 10),
               at(&Case::slider, &SliderCase::pitchInertia), withBearing,
               "Moment of inertia of the slider about its pitch axis through the mass centre.", typicalPico),
        number("slider.roll_inertia", "roll inertia", "", {"kg m^2", "kg m^2"}, between(1e-21, 10),
               at(&Case::slider, &SliderCase::rollInertia), withFilm,
               "Moment of inertia of the slider about its roll axis through the mass centre.", "a typical pico slider"),
    };
}

} // namespace touchdown
