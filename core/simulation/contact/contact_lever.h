// SPDX-License-Identifier: GPL-3.0-or-later
//
// Torques of forces under the slider about its mass centre, which is over the slider's middle, half the thickness b
// above its underside. A force F away from the disk at (x, y), and Coulomb friction of the real contact force N in the
// direction (u, v) of the disk under that point:
//
//   pitch torque, nose up       F (L/2 - x) - (b/2) mu N u
//   roll torque, inner edge up  F (W/2 - y) - (b/2) mu N v
#pragma once

#include "core/case/case.h"
#include "core/numerics/small_matrix.h"
#include "core/physics/contact/coulomb_friction.h"
#include "core/physics/disk/disk_velocity.h"

namespace touchdown {

/// The friction of the contact that the case names.
CoulombFriction frictionOf(const Case& c);

class ContactLever {
public:
    explicit ContactLever(const Case& c);

    /// (force, pitch torque, roll torque) of 1 N at (x, y); also the derivatives of the height there by q.
    Vector3 arms(double x, double y) const { return {1.0, 0.5 * length_ - x, 0.5 * width_ - y}; }

    struct Rubbing {
        double force = 0.0;                         // in the disk's direction [-]
        double pitchTorque = 0.0, rollTorque = 0.0; // [m]
    };
    /// Friction for 1 N of real contact force at (x, y).
    Rubbing rubbing(double x, double y) const;

private:
    double length_, width_; // [m]
    DiskMotion disk_;
    CoulombFriction friction_;
};

} // namespace touchdown
