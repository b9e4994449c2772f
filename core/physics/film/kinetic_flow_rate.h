// SPDX-License-Identifier: GPL-3.0-or-later
//
// Poiseuille flow rate Q_P(D) of a rarefied gas between plates that reflect diffusely, D = (sqrt(pi)/2)/Kn the inverse
// Knudsen number: the solution of the linearised BGK equation, and the published fit of it.
//
//   D -> 0         Q_P -> -ln(D)/sqrt(pi) + constant            free molecules
//   D -> infinity  Q_P -> D/6 + 1.0162 + 1.0653/D               slip flow
//
// The kinetic values are those of the variational principle of Cercignani & Pagani 1966 with the trial velocity A + B
// x^2, which Fukui & Kaneko 1990 tabulate. They lie up to 0.2 % below the exact solution of the BGK equation (near D =
// 10), and the fit within 0.9 % of them.
#pragma once

namespace touchdown {

struct FlowRate {
    double value;    // Q_P [-]
    double logSlope; // dQ_P/d ln D [-]
};

/// The kinetic values for D > 0: continuously differentiable, 6 Q_P/D falls everywhere. 1e-4 <= D <= 100: the
/// variational solution to 4e-7; the free molecules' law below, a transition to slip flow within 100..1000.
FlowRate kineticFlowRate(double inverseKnudsen);

/// The fit in three parts of Fukui & Kaneko 1988, with its jumps of 0.14 % at D = 5 and 0.27 % at D = 0.15; below D =
/// 0.01, where it ends, continued by the free molecules' law.
FlowRate fittedFlowRate(double inverseKnudsen);

inline constexpr double leastFittedInverseKnudsen = 0.01;

/// The fit's three parts, a D + b + c/D + e/D^2, for D >= leastFittedInverseKnudsen; runs on vectors.
inline FlowRate fittedParts(double d)
{
    const bool wide = d >= 5.0, middle = d >= 0.15;
    const double a = wide ? 1.0 / 6.0 : middle ? 0.13852 : -2.22919, b = wide ? 1.0162 : middle ? 1.25087 : 2.10673;
    const double c = wide ? 1.0653 : middle ? 0.15653 : 0.01653, e = wide ? -2.1354 : middle ? -0.00969 : -0.0000694;
    const double inverse = 1.0 / d;
    return {a * d + b + (c + e * inverse) * inverse, a * d - (c + 2.0 * e * inverse) * inverse};
}

} // namespace touchdown
