// SPDX-License-Identifier: GPL-3.0-or-later
//
// The slider as a rigid body with its suspension. Coordinates q: height of the mass centre z [m], pitch, roll [rad];
// forces about the mass centre [N], [N m]. The mass centre lies over the slider's middle:
//
//   M q'' = film + contact + load - K (q - q_0) - C q'
//
// K, C: suspension, about the state q_0 in which it exerts the load: preload and torques.
#pragma once

#include <array>

#include "core/numerics/small_matrix.h"
#include "core/physics/slider/attitude.h"

namespace touchdown {

struct Case;

/// Load on the slider.
struct SliderLoad {
    double preload = 0.0;                             // [N]
    double pitchTorque = 0.0, rollTorque = 0.0;       // of preload and static torques about the slider's centre [N m]
    double pitchStiffness = 0.0, rollStiffness = 0.0; // [N m/rad]; zero unless the suspension holds the attitude
    double staticPitch = 0.0, staticRoll = 0.0;       // [rad]
    double shearArm = 0.0;                            // pitch and roll torque per shear force [m]
    bool holdsRoll = false;                           // two degrees of freedom: the roll is constant
    double heldRoll = 0.0;                            // [rad]
};
SliderLoad sliderLoad(const Case& c);

/// A stiffness against which the roll does not change; any value on its diagonal holds it exactly.
void holdRoll(Matrix3& stiffness);

struct SliderMotion {
    Vector3 q = Vector3::Zero(), v = Vector3::Zero(), a = Vector3::Zero(); // position, velocity, acceleration
    void pass(auto& stream) { stream(q, v, a); }
};

class SliderBody {
public:
    /// `rest`: where the suspension exerts its load.
    SliderBody(const Case& c, const Attitude& rest);

    Attitude attitude(const Vector3& q) const { return {q[0] - 0.5 * length_ * q[1], q[1], q[2]}; }
    Vector3 coordinates(const Attitude& a) const { return {a.height + 0.5 * length_ * a.pitch, a.pitch, a.roll}; }

    /// Force of the suspension: load, springs, dampers.
    Vector3 suspension(const Vector3& q, const Vector3& v) const;
    double length() const { return length_; } // [m]
    double width() const { return width_; }   // [m]
    const Vector3& inertia() const { return inertia_; }
    const Vector3& springs() const { return springs_; }
    const Vector3& dampers() const { return dampers_; }
    const Vector3& rest() const { return rest_; }
    const Vector3& load() const { return load_; }
    /// Pitch and roll torque per shear force of the film [m], signs as in SliderLoad.
    double shearArm() const { return shearArm_; }
    bool holdsRoll() const { return holdsRoll_; }
    /// Load and torques of the film about the mass centre, of GasFilm::loadAndShear().
    Vector3 filmForce(const std::array<double, 5>& film) const
    {
        return {film[0], film[1] - shearArm_ * film[3], film[2] - shearArm_ * film[4]};
    }

    double kineticEnergy(const Vector3& v) const; // [J]
    /// Energy of springs and load, zero at rest [J].
    double suspensionEnergy(const Vector3& q) const;
    /// The largest displacement of the slider's corners for a change of q [m].
    double displacement(const Vector3& change) const;

private:
    double length_, width_; // [m]
    Vector3 inertia_, springs_, dampers_, rest_, load_;
    double shearArm_ = 0.0;
    bool holdsRoll_ = false;
};

/// The body of a case on the film of another one: where its suspension exerts its load, the film of a stiffness takes
/// the difference of the two loads.
SliderBody bodyUnderLoad(const Case& c, const SliderBody& before, Matrix3 filmStiffness);

} // namespace touchdown
