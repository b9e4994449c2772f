// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact of a smooth flat with a statistical rough surface (Greenwood & Williamson 1966), per unit of area. d is the
// separation of the flat and the disk's mean plane. The summits' mean plane is higher by y_s (Asperities::planeHeight;
// of an isotropic Gaussian surface 0.045944/(eta R), McCool 1986; Chang, Etsion & Bogy 1987). A summit of height z
// above its plane is pressed by w = z - (d - y_s). With the density phi of Gaussian heights,
//
//   p = eta int P(w) phi(z) dz over w > 0, likewise the contacts (P -> 1), their area (P -> A) and energy.
//
//   greenwood-williamson   P = (4/3) E* sqrt(R) w^(3/2), A = pi R w (Hertz)
//   elastic-plastic        the same up to w_c = (pi K H/(2 E*))^2 R. Beyond w_c the summit's volume is conserved
//                          under the pressure K H: A = pi R (2 w - w_c), P = K H A; H = 2.8 Y, K = 0.454 + 0.41 nu,
//                          nu of the disk (Chang, Etsion & Bogy 1987, 1988). As in their model, P of one summit jumps
//                          at w_c from 2/3 to 1 of K H A; p does not jump. It depends on d alone: neither their model
//                          nor this one describes unloading after plastic flow.
//
// Pressure, stiffness and energy come from one table of polynomials in t = (d - y_s)/sigma_s. They match the energy and
// its first three derivatives at both ends, so p = -dW/dd and the stiffness -dp/dd hold exactly. The error is below
// 1e-9 of p or p(0), whichever is larger. Left of the table all summits are elastic or all flow, and the moments of w
// are known. Where only some of them flow there, the integral is evaluated (5 us).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/physics/contact/contact_bodies.h"

namespace touchdown {

class AsperityContact {
public:
    /// Radius, density, deviation and moduli are positive; so is the yield strength, where it is used.
    AsperityContact(const Asperities& asperities, const ElasticPair& pair);

    double pressure(double separation) const;  // p >= 0 [Pa]
    double stiffness(double separation) const; // -dp/dd >= 0 [Pa/m]
    /// W, the work of pressing from afar [J/m^2]; stored, except the part that plastic flow dissipates.
    double energy(double separation) const;
    double contactArea(double separation) const;    // real over nominal [-], summed over summits: it may exceed 1
    double contactDensity(double separation) const; // [1/m^2]
    /// Nothing touches from this separation on [m].
    double reach() const { return planeHeight_ + upperEnd * sigma_; }
    /// w_c, where a summit begins to flow [m]; infinite for greenwood-williamson.
    double criticalInterference() const { return criticalInterference_; }

private:
    static constexpr double lowerEnd = -16.0; // of the table, in sigma_s
    static constexpr double upperEnd = 9.0;   // a height beyond it has probability 1e-19
    static constexpr int perDeviation = 4;    // pieces of the table in one sigma_s
    static constexpr int pieces = static_cast<int>(upperEnd - lowerEnd) * perDeviation;

    /// W and its derivatives to t.
    using Derivatives = std::array<double, 4>;
    Derivatives integrate(double t) const;
    Derivatives deep(double t) const;
    double summitForce(double interference) const;
    double summitEnergy(double interference) const;

    /// t = (d - y_s)/sigma_s.
    double deviations(double separation) const { return (separation - planeHeight_) * inverseSigma_; }
    /// A piece of the table and the place in it, 0..1.
    struct Place {
        const std::array<double, 8>& c;
        double x;
    };
    Place place(double t) const
    {
        const double at = (t - lowerEnd) * perDeviation;
        // t just below upperEnd may round up to it.
        const auto piece = std::min(static_cast<std::size_t>(at), table_.size() - 1);
        return {table_[piece], at - static_cast<double>(piece)};
    }

    double sigma_ = 0.0;                                // sigma_s [m]
    double inverseSigma_ = 0.0;                         // [1/m]
    double planeHeight_ = 0.0;                          // y_s [m]
    double density_ = 0.0;                              // eta [1/m^2]
    double radius_ = 0.0;                               // R [m]
    double hertz_ = 0.0;                                // (4/3) E* sqrt(R) [N/m^(3/2)]
    double flow_ = 0.0;                                 // pi R K H [N/m]
    double criticalInterference_ = 0.0;                 // w_c [m]
    std::array<std::array<double, 8>, pieces> table_{}; // W [J/m^2], coefficients of powers of the place in each piece
};

inline double AsperityContact::pressure(double separation) const
{
    const double t = deviations(separation);
    if (t >= upperEnd) return 0.0;
    if (t < lowerEnd) return -deep(t)[1] * inverseSigma_;
    const auto [c, x] = place(t);
    const double higher = 4.0 * c[4] + x * (5.0 * c[5] + x * (6.0 * c[6] + x * 7.0 * c[7]));
    const double slope = c[1] + x * (2.0 * c[2] + x * (3.0 * c[3] + x * higher));
    return -slope * perDeviation * inverseSigma_;
}

} // namespace touchdown
