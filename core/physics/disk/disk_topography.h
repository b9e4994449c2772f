// SPDX-License-Identifier: GPL-3.0-or-later
//
// The disk's surface as film, contact patch and plots sample it. w(x, y) [m] above the mean plane, in the disk's
// coordinates, is the sum of
//
//   waves      analytic, unbounded;
//   maps       generated or measured, each with its mean removed: a periodic cubic spline through the points, which
//              lie at multiples of the cell from x = y = 0. w has two continuous derivatives, also where the map
//              repeats. Halfway between points a wave of 2, 3, 4, 8, 16 cells keeps 0, 0.875, 0.972, 0.9988, 0.99994
//              of its amplitude;
//   bumps      analytic, periodic with the track; they do not change the mean plane.
//
// A surface that has moved by (sx, sy) is w(x - sx, y - sy). A map that has moved by whole cells returns the same bits.
// For this the positions, and separately the shift, are rounded to 2^-30 of a cell, or to the floating-point spacing at
// their size, if that is larger.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/numerics/periodic_spline.h"
#include "core/physics/disk/bumps.h"
#include "core/physics/disk/disk_point.h"
#include "core/physics/disk/disk_surface.h"
#include "core/physics/disk/height_map.h"
#include "core/physics/disk/waves.h"

namespace touchdown {

/// Constant after construction: any number of threads may read it. Only the constructor and cellMeans() without work
/// space allocate.
class DiskTopography {
public:
    /// Flat.
    DiskTopography() : DiskTopography(DiskSurface{}) {}
    /// `surface` without problems (core/physics/disk/disk_surface_check.h); `file` for the kinds that read one.
    /// Generates the roughness, 8 bytes per cell; if `goOn`, asked meanwhile, returns false there is none.
    explicit DiskTopography(const DiskSurface& surface, std::optional<HeightMap> file = {},
                            const std::function<bool()>& goOn = {});

    bool flat() const;

    /// w [m] at a point of the disk.
    double height(double x, double y) const;
    /// w and its slopes at a point of the disk, which is not rounded.
    DiskPoint point(double x, double y) const;
    /// w at the centres of the grid's cells, of the surface moved by the shift [m]. `out`: grid.cells() long.
    void heights(const UniformGrid& grid, double shiftX, double shiftY, std::span<double> out) const;
    /// The mean of w over each cell, for cells of any width: exact to rounding for waves and maps, for bumps to 0.5 %
    /// of their height. Waves shorter than a cell are averaged, not aliased.
    void cellMeans(const CellGrid& grid, double shiftX, double shiftY, std::span<double> out) const;
    /// The same for repeated calls: the first one allocates `work`.
    void cellMeans(const CellGrid& grid, double shiftX, double shiftY, std::span<double> out,
                   std::vector<double>& work) const;

    /// Bounds of w [m], a little beyond the extremes.
    double highest() const { return highest_; }
    double lowest() const { return lowest_; }
    /// A bound of w in a rectangle [m], closer the smaller it is.
    double upperBound(double x0, double x1, double y0, double y1) const;
    /// A bound of the curvature there: infinity at the base of an ellipsoid.
    CurvatureBound curvature(double x0, double x1, double y0, double y1) const;

    /// One period of the surface for plots and statistics, the cells' centres on the points of its finest map; without
    /// a map, the given track with the given cell.
    UniformGrid period() const { return period_; }
    /// Whether all of it repeats with period(): waves do not in general.
    bool repeats() const { return repeats_; }
    /// What statistics are taken of: period(), but only the points of the file, without their mirror image, where the
    /// surface is a measured one alone.
    UniformGrid measured() const { return measured_; }
    /// Whether the surface repeats with measured().
    bool measuredRepeats() const { return measuredRepeats_; }

private:
    Waves waves_;
    std::vector<PeriodicSpline> maps_;
    Bumps bumps_;
    double highest_ = 0.0, lowest_ = 0.0; // [m]
    UniformGrid period_;
    bool repeats_ = true;
    UniformGrid measured_;
    bool measuredRepeats_ = true;
};

} // namespace touchdown
