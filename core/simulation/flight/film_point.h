// SPDX-License-Identifier: GPL-3.0-or-later
//
// A state of a film run at one end of a step. Within a step the slider moves along the polynomial of fifth degree
// through position, velocity and acceleration at its ends.
#pragma once

#include "core/simulation/contact/slider_contact.h"
#include "core/simulation/static_state/slider_body.h"

namespace touchdown {

struct FilmPoint {
    double time = 0.0; // [s]
    SliderMotion motion;
    Vector3 filmForce = Vector3::Zero();
    SliderContactForces contact;
    double filmEnergy = 0.0; // stored by the air, from that of the static state [J]
    double gained = 0.0;     // since the start: input from the disk less dissipation [J]
    double dt = 0.0;         // of the step that led there [s]
};

/// Position and velocity at a share of the way from one point to the next.
SliderMotion between(const FilmPoint& from, const FilmPoint& to, double share);

} // namespace touchdown
