// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace touchdown {

/// Over a step (dx, dy), a function w(x, y) differs from its tangent plane by at most (x dx^2 + y dy^2)/2. Each
/// direction takes half of the term of the mixed derivative (Gershgorin 1931).
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
