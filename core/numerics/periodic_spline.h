// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cubic spline through values on the points (i dx, j dy), periodic with (nx dx, ny dy) (Unser 1999). The running
// sums of its coefficients are stored:
//
//   S_ij = sum of c_kl, k <= i, l <= j,     W(x, y) = dx dy sum of S_ij B(x/dx - i) B(y/dy - j),
//
// with B the quartic B-spline from 2 cells before to 3 behind: W is the spline's integral over x and y. A value is the
// mixed derivative of W, and the mean over a rectangle of any size is a second difference: both cost the same few
// terms.
#pragma once

#include <span>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/numerics/curvature_bound.h"

namespace touchdown {

class PeriodicSpline {
public:
    /// `values` [any unit] row by row, x fastest, nx ny of them.
    PeriodicSpline(int nx, int ny, double dx, double dy, std::vector<double> values);

    double value(double x, double y) const;
    /// The value and its derivatives by x and y, at the position itself, not rounded.
    struct Tangent {
        double value = 0.0, slopeX = 0.0, slopeY = 0.0; // [unit of the values], the slopes by [m]
    };
    Tangent tangent(double x, double y) const;
    /// Adds the values at the grid's centres, moved by the shift, to `out`.
    void addValues(const UniformGrid& grid, double shiftX, double shiftY, std::span<double> out) const;
    /// Adds the means over the grid's cells; allocates nothing once `work` has served for this spline.
    void addMeans(const CellGrid& grid, double shiftX, double shiftY, std::span<double> out,
                  std::vector<double>& work) const;

    int nx() const { return nx_; }
    int ny() const { return ny_; }
    double dx() const { return dx_; }
    double dy() const { return dy_; }
    /// Bounds of all values: the extremes of the coefficients.
    double upperBound() const { return upper_; }
    double lowerBound() const { return lower_; }
    /// A bound of the values in a rectangle: the largest coefficient of the blocks of 4 x 4 cells that it meets.
    double upperBound(double x0, double x1, double y0, double y1) const;
    /// A bound of the curvature there, of the same blocks.
    CurvatureBound curvature(double x0, double x1, double y0, double y1) const;

private:
    void setBlocks();
    double mostOf(const std::vector<float>& blocks, double all, double x0, double x1, double y0, double y1) const;

    int nx_ = 0, ny_ = 0;
    double dx_ = 0.0, dy_ = 0.0;
    std::vector<double> sums_; // S
    double upper_ = 0.0, lower_ = 0.0;
    CurvatureBound mostCurved_;
    int blocksX_ = 0, blocksY_ = 0;
    std::vector<float> blockUpper_, blockCurvatureX_, blockCurvatureY_; // row by row
};

} // namespace touchdown
