// SPDX-License-Identifier: GPL-3.0-or-later
//
// The slider as a rigid body with its suspension. Coordinates q: height of the mass centre z [m], pitch, roll [rad];
// forces about the mass centre [N], [N m]. The mass centre lies over the slider's middle:
//
//   M q'' = film + contact + load - K (q - q_0) - C q'
//
// K, C: suspension, about the state q_0 in which it exerts the load: preload and torques.
#pragma once

#include "core/physics/slider/attitude.h"
#include "core/simulation/static_state/flying_attitude.h"

namespace touchdown {

struct SliderMotion {
    Vector3 q{}, v{}, a{}; // position, velocity, acceleration
};

class SliderBody {
public:
    /// `rest`: where the suspension exerts its load.
    SliderBody(const Case& c, const Attitude& rest);

    Attitude attitude(const Vector3& q) const { return {q[0] - 0.5 * length_ * q[1], q[1], q[2]}; }
    Vector3 coordinates(const Attitude& a) const { return {a.height + 0.5 * length_ * a.pitch, a.pitch, a.roll}; }

    /// Of the suspension: load, springs, dampers.
    Vector3 suspension(const Vector3& q, const Vector3& v) const;
    const Vector3& inertia() const { return inertia_; }
    const Vector3& springs() const { return springs_; }
    const Vector3& dampers() const { return dampers_; }
    const Vector3& rest() const { return rest_; }
    const Vector3& load() const { return load_; }
    /// Pitch and roll torque per shear force of the film [m], signs as in SliderLoad.
    double shearArm() const { return shearArm_; }
    bool holdsRoll() const { return holdsRoll_; }

    double kineticEnergy(const Vector3& v) const; // [J]
    /// Of springs and load, zero at rest [J].
    double suspensionEnergy(const Vector3& q) const;
    /// The largest displacement of the slider's corners for a change of q [m].
    double displacement(const Vector3& change) const;

private:
    double length_, width_; // [m]
    Vector3 inertia_{}, springs_{}, dampers_{}, rest_{}, load_{};
    double shearArm_ = 0.0;
    bool holdsRoll_ = false;
};

} // namespace touchdown
