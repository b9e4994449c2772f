// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact of a smooth flat with a statistical rough surface (Greenwood & Williamson 1966), for each unit of area. A summit
// of height z above the summits' mean plane is pressed by w = z - d, where d is the separation of the flat and THAT plane
// (not the surface's own mean plane, which lies lower: summitPlaneHeight()). With the density phi of Gaussian heights,
//
//   p = eta int_d^inf P(z - d) phi(z) dz, likewise the contacts (P -> 1) and their area (P -> A) and energy.
//
//   greenwood-williamson   P = (4/3) E* sqrt(R) w^(3/2), A = pi R w (Hertz)
//   elastic-plastic        the same up to w_c = (pi K H/(2 E*))^2 R; beyond it the summit's volume is conserved under the
//                          pressure K H: A = pi R (2 w - w_c), P = K H A; H = 2.8 Y, K = 0.454 + 0.41 nu, nu of the disk
//                          (Chang, Etsion & Bogy 1987, 1988). P of one summit jumps at w_c from 2/3 to 1 of K H A, as
//                          theirs does; p does not. It depends on d alone: unloading after flow is not theirs, nor ours.
//
// Pressure, stiffness and energy come from one table in d/sigma_s of polynomials that agree with the energy's first
// derivatives up to the third at both ends, so p = -dW/dd and the stiffness -dp/dd hold exactly. Error of p below 1e-9 of
// p(0). Left of the table the integral itself is taken, which is slow.
#pragma once

#include <array>

#include "core/physics/asperities.h"
#include "core/physics/elastic_pair.h"

namespace touchdown {

class AsperityContact {
public:
    /// Radius, density, deviation and moduli are positive; so is the yield strength, where it is used.
    AsperityContact(const Asperities& asperities, const ElasticPair& pair);

    double pressure(double separation) const;       // p >= 0 [Pa]
    double stiffness(double separation) const;      // -dp/dd >= 0 [Pa/m]
    /// W = the work of pressing from afar [J/m^2]; stored, but for what flow takes.
    double energy(double separation) const;
    double contactArea(double separation) const;    // real over nominal [-]; the summits are taken one by one, so it may pass 1
    double contactDensity(double separation) const; // [1/m^2]
    /// Nothing touches from this separation on [m].
    double reach() const { return upperEnd * sigma_; }
    /// w_c, where a summit begins to flow [m]; infinite for greenwood-williamson.
    double criticalInterference() const { return criticalInterference_; }

private:
    static constexpr double lowerEnd = -16.0; // of the table, in sigma_s
    static constexpr double upperEnd = 9.0;   // a height beyond it has probability 1e-19
    static constexpr int perDeviation = 4;    // pieces of the table in one sigma_s
    static constexpr int pieces = static_cast<int>(upperEnd - lowerEnd) * perDeviation;

    /// W, -dW/dt = sigma_s p, and its next two derivatives at t = d/sigma_s.
    using Derivatives = std::array<double, 4>;
    Derivatives integrate(double t) const;
    double summitForce(double interference) const;
    double summitEnergy(double interference) const;
    double derivative(double separation, int order) const;

    double sigma_ = 0.0;                // sigma_s [m]
    double density_ = 0.0;              // eta [1/m^2]
    double radius_ = 0.0;               // R [m]
    double hertz_ = 0.0;                // (4/3) E* sqrt(R) [N/m^(3/2)]
    double flow_ = 0.0;                 // pi R K H [N/m]
    double criticalInterference_ = 0.0; // w_c [m]
    std::array<std::array<double, 8>, pieces> table_{}; // W in each piece, powers of its own coordinate 0..1 [J/m^2]
};

/// Height of the summits' mean plane above the surface's [m], y_s = 0.045944/(eta R) (Bush, Gibson & Keogh 1976, as McCool
/// 1986 and Chang, Etsion & Bogy 1987 use it). d of this file is the separation of the surface's mean plane less y_s.
inline double summitPlaneHeight(const Asperities& asperities)
{
    return 0.045944 / (asperities.density * asperities.radius);
}

} // namespace touchdown
