// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace touchdown {

/// Of a function w(x, y): over a way (dx, dy) it differs from its tangent by at most (x dx^2 + y dy^2)/2. Half of what
/// the mixed derivative adds counts for each side (Gershgorin 1931).
struct CurvatureBound {
    double x = 0.0, y = 0.0; // [unit of w/m^2]
    CurvatureBound& operator+=(const CurvatureBound& other)
    {
        x += other.x;
        y += other.y;
        return *this;
    }
};

} // namespace touchdown
