// SPDX-License-Identifier: GPL-3.0-or-later
//
// One lumped air bearing spring (Ono & Yamane; Chen & Bogy, equation (1)):
//
//   F(z) = k_0 z_0^2 / z^2 (z_0 - z)   for z > d_1,   0 for z < d_1
//
// and its potential, as in equation (5):  U(z) = k_0 z_0^2 [ z_0/z - ln(z_0/z) - 1 ].
// Below d_1 the force is zero, so the potential is held at U(d_1). Equation (5) as printed continues
// below d_1, and takes the logarithm of a negative number where z < 0: `AsPrinted` shows that, with
// the real part of the logarithm, so that the energy can become negative.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace touchdown {

enum class PotentialBelowCutoff : std::uint8_t { Held, AsPrinted };

struct AirSpring {
    double stiffness = 0.0;     // k_0 [N/m], at the static spacing
    double staticSpacing = 0.0; // z_0 [m], > cutoff
    double cutoff = 0.0;        // d_1 [m], > 0

    /// The smooth law, for a spring that carries [N]; z != 0.
    double force(double z) const { return stiffness * staticSpacing * staticSpacing * (staticSpacing - z) / (z * z); }
    /// dF/dz of the smooth law [N/m]; z != 0.
    double tangent(double z) const
    {
        return stiffness * staticSpacing * staticSpacing * (z - 2.0 * staticSpacing) / (z * z * z);
    }
    /// [J]; finite and >= 0 when held, for any z.
    double potential(double z, PotentialBelowCutoff below = PotentialBelowCutoff::Held) const
    {
        if (stiffness == 0.0) return 0.0;
        const double ratio = staticSpacing / (below == PotentialBelowCutoff::Held ? std::max(z, cutoff) : z);
        return stiffness * staticSpacing * staticSpacing * (ratio - std::log(std::abs(ratio)) - 1.0);
    }
};

} // namespace touchdown
