// SPDX-License-Identifier: GPL-3.0-or-later
//
// The energy balance of a run. Slider, suspension, air and contact hold an energy E. They gain energy
//
//   by flows of the air        the disk's input less the viscous dissipation (core/physics/film/film_energy.h)
//   by the disk's surface      which rises and falls under the air
//   by shear, friction         through their torques
//   by contact and adhesion    their work on the slider that is not stored
//   by the dampers             a negative amount
//
// so that E - gained is constant to the error of discretisation: of time, and of the load, which includes layers at
// steps that the cells' own pressure does not have (some 1e-3 of the air's exchange).
#pragma once

#include "core/simulation/flight/film_point.h"

namespace touchdown {

class FilmInTime;

class FilmEnergyBalance {
public:
    /// Film and body must last. `restEnergy`: of the air, from which it is counted [J].
    FilmEnergyBalance(FilmInTime& film, const SliderBody& body, double restEnergy)
        : film_(film), body_(body), rest_(restEnergy)
    {}

    /// Sets the energy of the air.
    void begin(FilmPoint& point);
    /// Sets energy and gain after an accepted step from `before`.
    void add(const FilmPoint& before, FilmPoint& point);

    void pass(auto& stream) { stream(flows_, shear_, lastPower_, earlierPower_, lastDt_); }

private:
    /// Of flows, contact, shear and dampers at a point, whose flows and shear are the last ones [W].
    double power(const FilmPoint& point) const;

    FilmInTime& film_;
    const SliderBody& body_;
    double rest_;                                 // [J]
    double flows_ = 0.0;                          // their power into the air there [W]
    Vector3 shear_ = Vector3::Zero();             // torques there [N m]
    double lastPower_ = 0.0, earlierPower_ = 0.0; // at the end and the beginning of the last step [W],
    double lastDt_ = 0.0;                         // its length; zero: none yet [s]
};

} // namespace touchdown
