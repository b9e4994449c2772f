// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/film_books.h"

#include <algorithm>

namespace touchdown {

void FilmBooks::begin(const CoupledStepper& stepper, FilmPoint& point)
{
    point.filmEnergy = energy_.at(stepper.pressure()).stored - rest_;
    shear_ = stepper.shearTorques();
    pressure_.assign(stepper.pressure().begin(), stepper.pressure().end());
    surface_.assign(stepper.surface().begin(), stepper.surface().end());
}

void FilmBooks::add(const CoupledStepper& stepper, const FilmPoint& before, FilmPoint& point)
{
    const FilmEnergyState air = energy_.at(stepper.pressure());
    const double dt = point.time - before.time, flows = air.input - air.dissipation;
    point.filmEnergy = air.stored - rest_;
    double gained = 0.5 * dt * (flows_ + flows) + point.contact.storedEnergy - before.contact.storedEnergy;
    if (!surface_.empty()) {
        gained += energy_.surfaceWork(pressure_, stepper.pressure(), surface_, stepper.surface());
        std::ranges::copy(stepper.pressure(), pressure_.begin());
        std::ranges::copy(stepper.surface(), surface_.begin());
    }
    const Vector3 contact = point.contact.load(), contactBefore = before.contact.load(), shear = stepper.shearTorques();
    for (std::size_t k = 0; k < 3; ++k) {
        const double way = point.motion.q[k] - before.motion.q[k];
        const double damping = body_.dampers()[k] * 0.5 * (before.motion.v[k] + point.motion.v[k]);
        gained += (0.5 * (contactBefore[k] + contact[k] + shear_[k] + shear[k]) - damping) * way;
    }
    flows_ = flows;
    shear_ = shear;
    point.gained = before.gained + gained;
}

} // namespace touchdown
