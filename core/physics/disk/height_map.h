// SPDX-License-Identifier: GPL-3.0-or-later
//
// A measured surface: heights on equally spaced points. It repeats continuously: directly if it is closed, i.e. the
// last row or column is the first one again (a whole turn of the disk); otherwise followed by its mirror image.
#pragma once

#include <vector>

namespace touchdown {

struct HeightMap {
    int nx = 0, ny = 0;                    // points; ny = 1: a profile along the track, the same across
    double dx = 0.0, dy = 0.0;             // between points [m]; dy means nothing for a profile
    std::vector<double> heights;           // row by row, x fastest [m]; finite
    bool closedX = false, closedY = false; // the last point is the first one again and is left out of nx, ny
    bool operator==(const HeightMap&) const = default;
};

} // namespace touchdown
