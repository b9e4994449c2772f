// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the slider is above the mean plane of the disk: h = height + pitch (L - x) - roll (y - W/2) + recess.
#pragma once

namespace touchdown {

struct Attitude {
    double height = 0.0; // nominal: of the trailing edge's centre, recess 0 [m]
    double pitch = 0.0;  // leading edge up [rad]
    double roll = 0.0;   // inner edge up [rad]
};

} // namespace touchdown
