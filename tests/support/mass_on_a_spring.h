// SPDX-License-Identifier: GPL-3.0-or-later
//
// A slider in almost no air on a spring, for exact answers of a coupled step.
#pragma once

#include "core/simulation/contact/slider_contact.h"
#include "tests/support/flying_slider.h"

namespace touchdown::test {

/// So tight that what is left of a step does not count beside its discretisation.
inline CoupledStepOptions tight(FilmCoupling coupling)
{
    return {
        .coupling = coupling, .film = {.tolerance = 1e-12, .share = 0.0, .maximumIterations = 30}, .tolerance = 1e-17};
}

inline CoupledStepOptions byDefault(FilmCoupling coupling)
{
    CoupledStepOptions options;
    options.coupling = coupling;
    return options;
}

/// A spring under the mass centre and a force that jumps when the law is crossed. It may state a wrong stiffness.
class SpringAndJump final : public SliderContact {
public:
    SpringAndJump(double stiffness, double middle, double jump, double stated = 1.0)
        : stiffness_(stiffness), middle_(middle), jump_(jump), stated_(stated)
    {}
    const SliderContactForces& at(const Attitude& attitude, double) override
    {
        forces_.contact = -stiffness_ * (attitude.height + 0.5 * length * attitude.pitch - middle_) + force_;
        return forces_;
    }
    Matrix3 stiffness() const override
    {
        Matrix3 result = Matrix3::Zero();
        result(0, 0) = stated_ * stiffness_;
        return result;
    }
    bool outOfReach(const Attitude&) const override { return false; }
    void accept() override {}
    std::string cross(bool) override
    {
        force_ += jump_;
        return "jump";
    }
    static constexpr double length = 1.25e-3; // of the slider [m]

private:
    double stiffness_, middle_, jump_, force_ = 0.0; // [N/m], [m], [N]
    double stated_;                                  // of the stiffness [-]
    SliderContactForces forces_;
};

/// Next to no air, a disk that stands still, no suspension: what moves is the mass on the contact's spring.
inline Case almostVacuum()
{
    Case c = openCase("film_plane").value;
    c.film.nodes = {17, 17};
    c.film.grid = GridKind::Uniform;
    c.air.given.pressure = 1e-6;
    c.disk.speed = 0.0;
    c.suspension.stiffness = c.suspension.pitchStiffness = c.suspension.rollStiffness = 0.0;
    c.suspension.damping = c.suspension.pitchDamping = c.suspension.rollDamping = 0.0;
    return c;
}
inline SteadyResult filmAtAmbient(const Case& c)
{
    SteadyResult rest;
    rest.attitude = {1e-6, 0.0, 0.0};
    rest.grid = uniformGrid(c.slider.length, c.slider.width, 16, 16);
    rest.pressure.assign(16 * 16, c.air.given.pressure);
    return rest;
}

} // namespace touchdown::test
