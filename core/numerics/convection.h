// SPDX-License-Identifier: GPL-3.0-or-later
//
// Flow between two nodes by convection and diffusion, F = c (p1 + p2)/2 - E (p2 - p1), with the schemes' effective
// conductance E(K, c); K is the conductance of diffusion, c of convection, Pe = c/K the cell Peclet number.
//
//   upwind       E = K + |c|/2
//   hybrid       E = max(K, |c|/2)                        Spalding 1972
//   power law    E = K max(0, (1 - |Pe|/10)^5) + |c|/2    Patankar 1980, equation 5.34
//   exponential  E = K (Pe/2) coth(Pe/2)                  exact for constant K and c (Allen & Southwell 1955)
//
// All have E >= |c|/2, so that no node is pulled the wrong way: pressures stay positive and do not overshoot.
#pragma once

#include <cmath>
#include <cstdint>

namespace touchdown {

enum class ConvectionScheme : std::uint8_t { Upwind, Hybrid, PowerLaw, Exponential, CompleteFlux };

struct EffectiveConductance {
    double value;        // E
    double byDiffusion;  // dE/dK
    double byConvection; // dE/dc
};

/// u coth u and its derivative for u >= 0, to 2e-9 of the value.
struct CothProduct {
    double value, derivative;
};
inline CothProduct cothProduct(double u)
{
    if (u > 10.0) { // 2 u exp(-2u) is below 5e-8 of the value and falls fast
        const double tail = 2.0 * u * std::exp(-2.0 * u);
        return {u + tail, 1.0 + tail * (1.0 / u - 2.0)};
    }
    if (u < 0.02) { // series to u^4
        const double square = u * u;
        return {1.0 + square * (1.0 / 3.0 - square / 45.0), u * (2.0 / 3.0 - square * (4.0 / 45.0))};
    }
    const double decay = std::exp(-2.0 * u);
    const double scale = 1.0 / (1.0 - decay);
    const double coth = (1.0 + decay) * scale;
    return {u * coth, coth - u * 4.0 * decay * scale * scale};
}

template <ConvectionScheme scheme>
EffectiveConductance effectiveConductance(double K, double c)
{
    const double half = 0.5 * std::abs(c);
    const double sign = c < 0.0 ? -0.5 : 0.5;
    if constexpr (scheme == ConvectionScheme::Upwind)
        return {K + half, 1.0, sign};
    else if constexpr (scheme == ConvectionScheme::Hybrid)
        return K > half ? EffectiveConductance{K, 1.0, 0.0} : EffectiveConductance{half, 0.0, sign};
    else if constexpr (scheme == ConvectionScheme::PowerLaw) {
        const double base = 1.0 - 0.2 * half / K;
        if (!(base > 0.0)) return {half, 0.0, sign};
        const double fourth = base * base * base * base;
        // d/dK of K (1 - |c|/(10 K))^5 = base^5 + 5 base^4 |c|/(10 K)
        return {K * fourth * base + half, fourth * (base + half / K), sign * (1.0 - fourth)};
    } else {
        if (!(half < 1e8 * K)) return {half, 0.0, sign}; // also a closed face, with neither
        const double u = half / K;
        const CothProduct n = cothProduct(u);
        return {K * n.value, n.value - u * n.derivative, n.derivative * sign};
    }
}

} // namespace touchdown
