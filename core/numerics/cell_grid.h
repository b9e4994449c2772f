// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rectangles of nx x ny cells. Fields on them are stored row by row: x fastest.
#pragma once

#include <cstddef>
#include <vector>

namespace touchdown {

/// Divided by lines along x and y.
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
    void pass(auto& stream) { stream(x, y); }
};

/// A rectangle of nx x ny equal cells, values at their centres.
struct UniformGrid {
    int nx = 0, ny = 0;        // cells
    double dx = 0.0, dy = 0.0; // of a cell [m]
    double x0 = 0.0, y0 = 0.0; // the corner of the first cell [m]

    std::size_t cells() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
    std::size_t at(int i, int j) const
    {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i);
    }
    double x(int i) const { return x0 + (i + 0.5) * dx; } // of a centre [m]
    double y(int j) const { return y0 + (j + 0.5) * dy; }
    double cellArea() const { return dx * dy; } // [m^2]
    bool operator==(const UniformGrid&) const = default;
};

} // namespace touchdown
