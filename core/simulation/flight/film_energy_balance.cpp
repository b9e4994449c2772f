// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/film_energy_balance.h"

#include "core/simulation/flight/film_in_time.h"

namespace touchdown {

void FilmEnergyBalance::begin(FilmPoint& point)
{
    point.filmEnergy = film_.energy().stored - rest_;
    shear_ = film_.shearTorques();
}

double FilmEnergyBalance::power(const FilmPoint& point) const
{
    const Vector3 contact = point.contact.load();
    double sum = flows_;
    for (std::size_t k = 0; k < 3; ++k)
        sum += (contact[k] + shear_[k] - body_.dampers()[k] * point.motion.v[k]) * point.motion.v[k];
    return sum;
}

/// Power is integrated along a parabola through three points, or a straight line just after a switch of the law.
void FilmEnergyBalance::add(const FilmPoint& before, FilmPoint& point)
{
    const double powerBefore = power(before), dt = point.time - before.time;
    const FilmEnergyState air = film_.energy();
    point.filmEnergy = air.stored - rest_;
    flows_ = air.input - air.dissipation;
    shear_ = film_.shearTorques();
    const double powerNow = power(point);
    double gained = 0.5 * dt * (powerBefore + powerNow) + point.contact.storedEnergy - before.contact.storedEnergy;
    if (lastDt_ > 0.0 && powerBefore == lastPower_) {
        const double bend = ((powerNow - powerBefore) / dt - (powerBefore - earlierPower_) / lastDt_) / (dt + lastDt_);
        gained -= dt * dt * dt / 6.0 * bend;
    }
    earlierPower_ = powerBefore;
    lastPower_ = powerNow;
    lastDt_ = dt;
    gained += film_.surfaceWork();
    point.gained = before.gained + gained;
}

} // namespace touchdown
