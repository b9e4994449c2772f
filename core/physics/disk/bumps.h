// SPDX-License-Identifier: GPL-3.0-or-later
//
// Single bumps and pits on the disk, periodic with the track. With r = 1 on the ellipse of the base,
//
//   ellipsoid   h sqrt(1 - r^2), half an ellipsoid, vertical at the base;
//   cosine      h (1 + cos(pi r))/2;
//   gaussian    h exp(-4.5 r^2): the base is six standard deviations long and wide.
//
// Bumps that overlap add up.
#pragma once

#include <span>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/numerics/curvature_bound.h"
#include "core/physics/disk/disk_point.h"
#include "core/physics/disk/disk_surface.h"

namespace touchdown {

class Bumps {
public:
    Bumps() = default;
    explicit Bumps(const DiskSurface& surface);

    bool empty() const { return bumps_.empty(); }
    double height(double x, double y) const;
    /// Adds height and slopes; the slopes of an ellipsoid grow beyond all bounds towards its base.
    void addPoint(double x, double y, DiskPoint& to) const;
    /// Adds the heights at the grid's centres, moved by the shift, to `out`.
    void addHeights(const UniformGrid& grid, double shiftX, double shiftY, std::span<double> out) const;
    /// Adds the means over the grid's cells.
    void addMeans(const CellGrid& grid, double shiftX, double shiftY, std::span<double> out) const;

    /// Bounds of the height [m], from the sums of overlapping bumps.
    double highest() const { return highest_; }
    double lowest() const { return lowest_; }
    /// A bound of the height in a rectangle [m].
    double upperBound(double x0, double x1, double y0, double y1) const;
    /// A bound of the curvature there: infinity at the base of an ellipsoid.
    CurvatureBound curvature(double x0, double x1, double y0, double y1) const;

private:
    struct Bump {
        double height;                // [m]
        double halfLength, halfWidth; // of the base [m]
        double x, y;                  // [m]
    };
    /// Calls `visit(bump, x, y)` for each copy of a bump that reaches into the rectangle, (x, y) its centre.
    template <typename Visit>
    void forCopies(double left, double right, double inner, double outer, const Visit& visit) const;
    double shape(double rr) const;
    double shapeRate(double rr) const; // its derivative by r^2

    BumpShape shape_ = BumpShape::Ellipsoid;
    double reach_ = 1.0;                    // where the shape ends, in r [-]
    double track_ = 0.0, trackWidth_ = 0.0; // [m]
    std::vector<Bump> bumps_;
    double highest_ = 0.0, lowest_ = 0.0;
};

} // namespace touchdown
