// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nested grids: the coarser one has every second line of the finer one, and its last. Fields are padded arrays.
#pragma once

#include <span>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/numerics/padded_grid.h"

namespace touchdown {

CellGrid everySecondLine(const CellGrid& fine);

/// Between a grid and everySecondLine of it.
class GridTransfer {
public:
    explicit GridTransfer(const CellGrid& fine);

    /// Sums, and means by area, over the fine cells of each coarse cell.
    void sum(std::span<const double> fine, std::span<double> coarse) const;
    void mean(std::span<const double> fine, std::span<double> coarse) const;
    /// Bilinear between the centres; `coarse` is zero on the outline, its rings hold zeros.
    void interpolate(std::span<const double> coarse, std::span<double> fine) const;

private:
    struct Axis {
        std::vector<double> share; // of a fine cell's width in its coarse cell's [-]
        std::vector<int> other;    // the coarse cell, besides its own, that a fine centre lies towards
        std::vector<double> part;  // of the other one in the interpolation [-]
    };
    static Axis axisOf(const std::vector<double>& lines);

    PaddedGrid fine_, coarse_;
    Axis x_, y_;
};

} // namespace touchdown
