// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two rails over the whole length of a pico slider, with a taper: its modes are damped on any grid.
#pragma once

#include "tests/support/small_slider.h"

namespace touchdown::test {

inline Case taperFlat(int degreesOfFreedom = 2)
{
    Case c = smallSlider(33);
    c.slider = {.mass = 1.6e-6,
                .pitchInertia = 2.2e-13,
                .rollInertia = 1.45e-13,
                .length = 1.25e-3,
                .width = 1e-3,
                .thickness = 0.3e-3};
    c.surface.baseRecess = 3e-6;
    c.surface.taperLength = 0.15e-3;
    c.surface.taperAngle = 10e-3;
    c.surface.rails = {rectangle(0.0, 0.0, 1.25e-3, 0.12e-3, 0.0), rectangle(0.0, 0.88e-3, 1.25e-3, 1e-3, 0.0)};
    c.suspension.preload = 2.5e-3 * 9.80665;
    c.disk.speed = 565.0;
    c.degreesOfFreedom = degreesOfFreedom;
    return c;
}

} // namespace touchdown::test
