// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/slider_body.h"

#include <cmath>

#include "core/case/case.h"

namespace touchdown {

SliderLoad sliderLoad(const Case& c)
{
    const SuspensionCase& s = c.suspension;
    SliderLoad load;
    load.preload = s.preload;
    // Pressing down behind the centre lifts the nose, outside of it the inner edge.
    load.pitchTorque = s.preload * s.offsetX;
    load.rollTorque = s.preload * s.offsetY;
    if (s.holdsAttitude) {
        load.pitchStiffness = s.pitchStiffness;
        load.rollStiffness = s.rollStiffness;
        load.staticPitch = s.staticPitch;
        load.staticRoll = s.staticRoll;
    } else {
        load.pitchTorque += s.pitchTorque;
        load.rollTorque += s.rollTorque;
    }
    load.shearArm = c.steady.torqueSign * c.steady.shearArm * c.slider.thickness;
    load.holdsRoll = c.degreesOfFreedom == 2;
    load.heldRoll = c.initial.roll;
    return load;
}

void holdRoll(Matrix3& stiffness)
{
    stiffness.row(2).setZero();
    stiffness.col(2).setZero();
    stiffness(2, 2) = 1.0;
}

SliderBody::SliderBody(const Case& c, const Attitude& rest) : length_(c.slider.length), width_(c.slider.width)
{
    const SliderCase& s = c.slider;
    inertia_ = {s.mass, s.pitchInertia, s.rollInertia};
    springs_ = {c.suspension.stiffness, c.suspension.pitchStiffness, c.suspension.rollStiffness};
    dampers_ = {c.suspension.damping, c.suspension.pitchDamping, c.suspension.rollDamping};
    rest_ = coordinates(rest);
    const SliderLoad load = sliderLoad(c);
    load_ = {-load.preload, load.pitchTorque - load.pitchStiffness * (rest.pitch - load.staticPitch),
             load.rollTorque - load.rollStiffness * (rest.roll - load.staticRoll)};
    shearArm_ = load.shearArm;
    holdsRoll_ = load.holdsRoll;
}

Vector3 SliderBody::suspension(const Vector3& q, const Vector3& v) const
{
    return load_ - springs_.cwiseProduct(q - rest_) - dampers_.cwiseProduct(v);
}

double SliderBody::kineticEnergy(const Vector3& v) const
{
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) sum += 0.5 * inertia_[k] * v[k] * v[k];
    return sum;
}

double SliderBody::suspensionEnergy(const Vector3& q) const
{
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double way = q[k] - rest_[k];
        sum += (0.5 * springs_[k] * way - load_[k]) * way;
    }
    return sum;
}

double SliderBody::displacement(const Vector3& change) const
{
    return std::abs(change[0]) + 0.5 * length_ * std::abs(change[1]) + 0.5 * width_ * std::abs(change[2]);
}

SliderBody bodyUnderLoad(const Case& c, const SliderBody& before, Matrix3 filmStiffness)
{
    Vector3 load = SliderBody(c, before.attitude(before.rest())).load() - before.load();
    if (before.holdsRoll()) {
        holdRoll(filmStiffness);
        load[2] = 0.0;
    }
    return {c, before.attitude(before.rest() + solvePartialPivoting(filmStiffness, load))};
}

} // namespace touchdown
