// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where along a step a function is about least, from its slope alone: regula falsi within bounds, until the slope is a
// tenth of that at the start. Enough for a step of a descent.
#pragma once

#include <algorithm>
#include <cmath>

namespace touchdown {

/// `slope(part)`: the derivative of the function along the step at a part of it in [0, 1]. Returns that part: 1 where
/// the function still falls at the end or is flat there, 0 where it does not fall at the start.
template <typename Slope>
double lineMinimum(const Slope& slope)
{
    constexpr double flatShare = 0.1; // [-]
    constexpr int mostTries = 12;
    double lower = 0.0, upper = 1.0, slopeLower = slope(0.0);
    if (!(slopeLower < 0.0)) return 0.0;
    double slopeUpper = slope(1.0);
    const double flat = -flatShare * slopeLower;
    if (!(slopeUpper > flat)) return 1.0;
    double part = 1.0;
    for (int k = 0; k < mostTries; ++k) {
        part = lower + (upper - lower) * std::clamp(slopeLower / (slopeLower - slopeUpper), 0.1, 0.9);
        const double here = slope(part);
        if (std::abs(here) < flat) break;
        (here > 0.0 ? upper : lower) = part;
        (here > 0.0 ? slopeUpper : slopeLower) = here;
    }
    return part;
}

} // namespace touchdown
