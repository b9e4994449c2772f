// SPDX-License-Identifier: GPL-3.0-or-later
//
// A rectangle of nx x ny equal cells, values at their centres. Fields are stored row by row: x fastest.
#pragma once

#include <cstddef>

namespace touchdown {

struct UniformGrid {
    int nx = 0, ny = 0;        // cells
    double dx = 0.0, dy = 0.0; // of a cell [m]
    double x0 = 0.0, y0 = 0.0; // the corner of the first cell [m]

    std::size_t cells() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
    double x(int i) const { return x0 + (i + 0.5) * dx; } // of a centre [m]
    double y(int j) const { return y0 + (j + 0.5) * dy; }
    double cellArea() const { return dx * dy; } // [m^2]
    bool operator==(const UniformGrid&) const = default;
};

} // namespace touchdown
