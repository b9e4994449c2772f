// SPDX-License-Identifier: GPL-3.0-or-later
//
// Implicit formulas for dm/dt at the end of a step of length dt, from the values m1, m2, m3 before it. h1 and h2 are
// the two steps that led to m1, and r = dt/h1:
//
//   Euler    (m - m1)/dt                                              first order, L-stable
//   BDF2     ((1 + 2 r)/(1 + r) m - (1 + r) m1 + r^2/(1 + r) m2)/dt   second order, L-stable (Gear 1971;
//                                                                     variable steps)
//   BDF2OPT  BDF2 and 0.48 of the difference of BDF3 and BDF2         second order, half the error, L-stable
//                                                                     (Vatsa, Carpenter & Lockard 2010)
//   fitted   (m - m1)/dt, a (BDF2 - Euler) and b (BDF3 - BDF2)        exact for 1, t and exp(i omega t)
//
// In Newton's divided differences, BDF2 is f[t, t1] + dt f[t, t1, t2], and BDF3 adds dt (t - t2) f[t, t1, t2, t3].
// Without an earlier step each formula starts as Euler; BDF2OPT continues as BDF2. The same holds where a step is
// more than 1.5 times the one before, as BDF3 is stable up to a ratio of 1.53 (Calvo, Grande & Grigorieff 1990).
//
// In the fitted formula the real numbers a and b solve one complex equation: applied to exp(i omega t) it gives i omega
// (trigonometric fitting: Gautschi 1961). It is BDF3 as omega dt -> 0. With x0 = omega dt, exp(i x t/dt) is
// differentiated with the relative error -i x (x0^2 - x^2)/4. No formula that is exact for 1, t and a wave damps all
// slower and faster ones (Dahlquist's second barrier): this one lets undamped waves of x near 1.2 grow by 3 % a step
// for x0 = 0.6, and damps all whose damping ratio is above 0.07 for x0 from 0.3 to 1. It is used for
// 0.02 <= x0 <= 1.3 and steps that change by at most 1.25 times; elsewhere BDF2OPT is.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace touchdown {

constexpr double mostChangeForFit = 1.25; // of a step against the last one, either way

enum class BackwardRule : std::uint8_t { Euler, Bdf2, Bdf2Opt, Fitted };

/// dm/dt = perTime m - share[0] m1 - share[1] m2 - share[2] m3.
struct BackwardDifference {
    double perTime = 0.0;          // [1/s]
    std::array<double, 3> share{}; // [1/s]
    double taken = 0.0;            // of what BDF3 adds to BDF2; of the fitted formula what BDF2OPT takes [-]
    bool fitted = false;           // it is exact for exp(i omega t)
};

/// `h1` and `h2` [s] are zero where there was no such step. `rate`: omega of the fitted formula; zero: none [rad/s].
BackwardDifference backwardDifference(BackwardRule rule, double dt, double h1, double h2, double rate = 0.0);

/// Weights of the last four values, from m1 back, for the one at the end of a step: exact for 1, t, cos and sin omega
/// t, the cubic as omega dt -> 0. `h3` led to m3. None where the steps or omega dt do not allow the fitted formula.
std::optional<std::array<double, 4>> fittedForecast(double dt, double h1, double h2, double h3, double rate);

} // namespace touchdown
