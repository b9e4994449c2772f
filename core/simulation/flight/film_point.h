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
    void pass(auto& stream) { stream(time, motion, filmForce, contact, filmEnergy, gained, dt); }
};

/// Position and velocity at a share of the way from one point to the next.
inline SliderMotion between(const FilmPoint& from, const FilmPoint& to, double share)
{
    const double h = to.time - from.time, s = share, s2 = s * s, s3 = s2 * s;
    SliderMotion at;
    for (std::size_t k = 0; k < 3; ++k) {
        const double v0 = h * from.motion.v[k], a0 = h * h * from.motion.a[k];
        // The remainder for the upper three powers.
        const double q = to.motion.q[k] - from.motion.q[k] - v0 - 0.5 * a0;
        const double v = h * to.motion.v[k] - v0 - a0, a = h * h * to.motion.a[k] - a0;
        const double c3 = 10.0 * q - 4.0 * v + 0.5 * a, c4 = -15.0 * q + 7.0 * v - a, c5 = 6.0 * q - 3.0 * v + 0.5 * a;
        at.q[k] = from.motion.q[k] + s * v0 + 0.5 * s2 * a0 + s3 * (c3 + s * (c4 + s * c5));
        at.v[k] = h > 0.0 ? (v0 + s * a0 + s2 * (3.0 * c3 + s * (4.0 * c4 + s * 5.0 * c5))) / h : from.motion.v[k];
    }
    return at;
}

} // namespace touchdown
