// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace touchdown {

/// The disk's surface w(x, y) at a point.
struct DiskPoint {
    double height = 0.0;               // w [m]
    double slopeX = 0.0, slopeY = 0.0; // its derivatives by x and y [-]
};

} // namespace touchdown
