// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coulomb friction at the slider's underside, half its thickness b below the mass centre. v is the disk's velocity
// relative to the slider, x towards the trailing edge:
//
//   F = mu N tanh(v/v_r)   on the slider, in the direction in which the disk runs
//   M = -(b/2) F           about the mass centre, nose up: friction presses the nose down
//
// N is the real contact force without adhesion. v_r > 0 smooths the sign at v = 0; at |v| > 10 v_r, F is mu N to 1e-8.
#pragma once

#include <cmath>

namespace touchdown {

struct CoulombFriction {
    double coefficient = 0.3;        // mu [-]
    double arm = 0.15e-3;            // b/2 [m]
    double regularisingSpeed = 1e-5; // v_r [m/s]

    double force(double contactForce, double slidingVelocity) const // [N]
    {
        return coefficient * contactForce * std::tanh(slidingVelocity / regularisingSpeed);
    }
    /// Moment, nose down, per contact force in full sliding [m].
    double noseDown() const { return arm * coefficient; }
    double pitchMoment(double contactForce, double slidingVelocity) const // [N m]
    {
        return -arm * force(contactForce, slidingVelocity);
    }
};

} // namespace touchdown
