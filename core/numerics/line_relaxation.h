// SPDX-License-Identifier: GPL-3.0-or-later
//
// Alternating-direction zebra line relaxation of a monotone five-point operator: every second line along x, then those
// between, then the same along y (Brandt 1977; Wesseling 1992). Each line is a tridiagonal system. Padded arrays.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/numerics/padded_grid.h"

namespace touchdown {

/// Flow through the faces across an axis: F = c (v1 + v2)/2 - E (v2 - v1), E >= |c|/2; padded [any one unit].
struct MonotoneFaces {
    std::span<const double> effective, convection; // E, c
};

class LineRelaxation {
public:
    explicit LineRelaxation(const PaddedGrid& pad);

    /// A: the net outflow of the cells through these faces, plus `diagonal` times the `weight` of each.
    void setOperator(const std::array<MonotoneFaces, 2>& faces, std::span<const double> weight, double diagonal);
    /// Improves v (zero rings) towards A v = b by a sweep along x and one along y. Cells without flow get zero.
    void sweep(std::span<const double> b, std::span<double> v) const;
    /// out = b - A v.
    void residual(std::span<const double> b, std::span<const double> v, std::span<double> out) const;

private:
    void sweepX(std::span<const double> b, std::span<double> v, int colour) const;
    void sweepY(std::span<const double> b, std::span<double> v, int colour) const;

    PaddedGrid pad_;
    std::vector<double> west_, east_, south_, north_, centre_; // of the stencil
    std::vector<double> pivotX_, pivotY_;                      // 1/pivot of the lines
};

} // namespace touchdown
