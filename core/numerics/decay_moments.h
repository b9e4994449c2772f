// SPDX-License-Identifier: GPL-3.0-or-later
//
// exp(-z) and the moments of exp(-z s) over 0 <= s <= 1, what convection and diffusion through a layer need:
//
//   E_k(z) = integral of s^k exp(-z s) ds,   dE_k/dz = -E_(k+1),   z E_k = k E_(k-1) - exp(-z)  (z E_0 = 1 - exp(-z)).
//
// Relative errors below 2e-13 (exp: 1e-14). Without branches or calls, so that loops over many z run on vectors.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace touchdown {

/// exp(-z) for z >= 0; beyond 700 that of 700. exp(-z) = 2^n exp(r), |r| <= ln(2)/2, by Taylor's series to r^11.
inline double decay(double z)
{
    constexpr double perLog2 = 1.4426950408889634, log2High = 0x1.62e42fefa3800p-1, log2Low = 0x1.ef35793c76730p-45;
    constexpr double integers = 0x1.8p52; // adding it leaves the nearest integer in the lowest bits
    z = std::min(z, 700.0);
    const double shifted = integers - z * perLog2;
    const double n = shifted - integers;
    const double r = (-z - n * log2High) - n * log2Low;
    const double r2 = r * r, r4 = r2 * r2;
    const double low = (1.0 + r) + r2 * (1.0 / 2 + r * (1.0 / 6));
    const double middle = (1.0 / 24 + r * (1.0 / 120)) + r2 * (1.0 / 720 + r * (1.0 / 5040));
    const double high = (1.0 / 40320 + r * (1.0 / 362880)) + r2 * (1.0 / 3628800 + r * (1.0 / 39916800));
    const double power = std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) + 1023) << 52);
    return power * (low + r4 * (middle + r4 * high));
}

struct DecayMoments {
    double decay, e0, e1, e2; // exp(-z), E_0, E_1, E_2
};

inline DecayMoments decayMoments(double z)
{
    constexpr double small = 0.125;
    DecayMoments m;
    m.decay = decay(z);
    // Downwards, all terms are positive and nothing cancels; so E_2 comes first: upwards, or as a series where that
    // cancels.
    const double inverse = 1.0 / std::max(z, small);
    const double upwards = (2.0 * ((1.0 - m.decay) * inverse - m.decay) * inverse - m.decay) * inverse;
    const double series =
        1.0 / 3 -
        z * (1.0 / 4 - z * (1.0 / 10 -
                            z * (1.0 / 36 - z * (1.0 / 168 - z * (1.0 / 960 - z * (1.0 / 6480 - z * (1.0 / 50400)))))));
    m.e2 = z > small ? upwards : series;
    m.e1 = 0.5 * (z * m.e2 + m.decay);
    m.e0 = z * m.e1 + m.decay;
    return m;
}

} // namespace touchdown
