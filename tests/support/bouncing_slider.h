// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sliders on springs that bounce for ever, as their contact law creates energy (W < 0).
#pragma once

#include "core/case/case.h"

namespace touchdown::test {

/// The default slider at 3.2 nm without friction; W = f_m 1 nm - 2.5 pJ.
inline Case bouncingSlider(double meniscusForce = 1e-3)
{
    Case c;
    c.springs.flyingHeight = 3.2e-9;
    c.onoYamane.takeOff = 4e-9;
    c.onoYamane.friction = 0.0;
    c.onoYamane.meniscusForce = meniscusForce;
    return c;
}

/// A linear oscillator with a relay: no air springs, a pad below the mass centre, and a contact force of 4 mN between
/// the crossing of d_s downwards and that of d_e upwards. The pitch oscillates by itself.
inline Case relaySlider()
{
    Case c = bouncingSlider();
    c.springs.frontStiffness = c.springs.rearStiffness = 0.0;
    c.springs.pitch = 0.0;
    c.suspension.stiffness = 1.6e6;
    c.suspension.pitchStiffness = 0.05;
    c.suspension.dampingRatio = 0.02;
    c.suspension.pitchDampingRatio = 0.03;
    c.springs.padDistance = 0.0;
    c.onoYamane.contactStiffness = 0.0;
    c.initial.flyingHeight = 20e-9;
    c.initial.pitch = 0.0;
    return c;
}

} // namespace touchdown::test
