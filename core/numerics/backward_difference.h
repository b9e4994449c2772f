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
//
// In Newton's divided differences, BDF2 is f[t, t1] + dt f[t, t1, t2], and BDF3 adds dt (t - t2) f[t, t1, t2, t3].
// Without an earlier step each formula starts as Euler; BDF2OPT continues as BDF2. The same holds where a step is
// more than 1.5 times the one before, as BDF3 is stable up to a ratio of 1.53 (Calvo, Grande & Grigorieff 1990).
#pragma once

#include <array>
#include <cstdint>

namespace touchdown {

enum class BackwardRule : std::uint8_t { Euler, Bdf2, Bdf2Opt };

/// dm/dt = perTime m - share[0] m1 - share[1] m2 - share[2] m3.
struct BackwardDifference {
    double perTime = 0.0;          // [1/s]
    std::array<double, 3> share{}; // [1/s]
    double taken = 0.0;            // of what BDF3 adds to BDF2 [-]
};

/// `h1` and `h2` [s] are zero where there was no such step.
BackwardDifference backwardDifference(BackwardRule rule, double dt, double h1, double h2);

} // namespace touchdown
