// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the slider is above the mean plane of the disk: h = height + pitch (L - x) - roll (y - W/2) + recess.
#pragma once

#include <algorithm>
#include <cmath>

namespace touchdown {

struct Attitude {
    double height = 0.0; // nominal: of the trailing edge's centre, recess 0 [m]
    double pitch = 0.0;  // leading edge up [rad]
    double roll = 0.0;   // inner edge up [rad]
};

/// The largest displacement of the corners of a slider of this length and width [m] from one attitude to another [m].
inline double displacement(const Attitude& from, const Attitude& to, double length, double width)
{
    const double tail = to.height - from.height, nose = tail + length * (to.pitch - from.pitch);
    return std::max(std::abs(tail), std::abs(nose)) + 0.5 * width * std::abs(to.roll - from.roll);
}

} // namespace touchdown
