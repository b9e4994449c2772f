// SPDX-License-Identifier: GPL-3.0-or-later
//
// Micro-waviness: a sum of plane waves a sin(2 pi (x cos b + y sin b)/l + c).
#pragma once

#include <span>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/numerics/curvature_bound.h"
#include "core/physics/disk/disk_point.h"
#include "core/physics/disk/disk_surface.h"

namespace touchdown {

class Waves {
public:
    Waves() = default;
    explicit Waves(const DiskSurface& surface);

    bool empty() const { return waves_.empty(); }
    double height(double x, double y) const;
    /// Adds height and slopes.
    void addPoint(double x, double y, DiskPoint& to) const;
    /// Adds the heights at the grid's centres, moved by the shift, to `out`.
    void addHeights(const UniformGrid& grid, double shiftX, double shiftY, std::span<double> out) const;
    /// Adds the means over the cells: of a wave the height in the middle times sin(u)/u along x and y, u = k width/2.
    void addMeans(const CellGrid& grid, double shiftX, double shiftY, std::span<double> out) const;
    double amplitude() const; // the sum of all [m]
    /// A bound of the height in a rectangle [m]: each wave's own highest point there.
    double upperBound(double x0, double x1, double y0, double y1) const;
    CurvatureBound curvature() const;

private:
    struct Wave {
        double amplitude, kx, ky, phase; // [m], [rad/m], [rad]
    };
    std::vector<Wave> waves_;
};

} // namespace touchdown
