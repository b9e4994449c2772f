// SPDX-License-Identifier: GPL-3.0-or-later
//
// A rectangle divided by lines along x and y into nx x ny cells. Fields on its cells are stored row by row: x fastest.
#pragma once

#include <cstddef>
#include <vector>

namespace touchdown {

struct CellGrid {
    std::vector<double> x; // nx + 1 ascending lines [m]
    std::vector<double> y; // ny + 1 ascending lines [m]

    int nx() const { return static_cast<int>(x.size()) - 1; }
    int ny() const { return static_cast<int>(y.size()) - 1; }
    std::size_t cells() const { return (x.size() - 1) * (y.size() - 1); }
    double centreX(int i) const { return 0.5 * (x[static_cast<std::size_t>(i)] + x[static_cast<std::size_t>(i) + 1]); }
    double centreY(int j) const { return 0.5 * (y[static_cast<std::size_t>(j)] + y[static_cast<std::size_t>(j) + 1]); }
    double widthX(int i) const { return x[static_cast<std::size_t>(i) + 1] - x[static_cast<std::size_t>(i)]; }
    double widthY(int j) const { return y[static_cast<std::size_t>(j) + 1] - y[static_cast<std::size_t>(j)]; }
};

} // namespace touchdown
