// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/disk_topography.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/physics/disk/disk_surface_check.h"
#include "core/physics/disk/roughness.h"

namespace touchdown {

namespace {

/// Cells of the period of a surface without a map, at most.
constexpr double mostColumns = 4096.0;
constexpr double mostRows = 512.0;

/// One axis of a measured map: as it is where it is closed, else followed by its mirror image without the end points.
struct Axis {
    int points, period;

    Axis(int n, bool closed) : points(n), period(closed || n < 2 ? n : 2 * (n - 1)) {}
    std::size_t source(int i) const { return static_cast<std::size_t>(i < points ? i : period - i); }
};

PeriodicSpline splineOf(const HeightMap& map)
{
    const Axis along(map.nx, map.closedX), across(map.ny, map.closedY);
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(along.period) * static_cast<std::size_t>(across.period));
    double sum = 0.0;
    for (int j = 0; j < across.period; ++j)
        for (int i = 0; i < along.period; ++i) {
            values.push_back(map.heights[across.source(j) * static_cast<std::size_t>(map.nx) + along.source(i)]);
            sum += values.back();
        }
    const double mean = sum / static_cast<double>(values.size());
    for (double& h : values) h -= mean;
    // A profile is one row, whose distance to the next does not matter.
    return {along.period, across.period, map.dx, map.ny > 1 ? map.dy : map.dx, std::move(values)};
}

/// Cells whose centres lie on the points of a map.
UniformGrid gridOf(const PeriodicSpline& map)
{
    return {map.nx(), map.ny(), map.dx(), map.dy(), -0.5 * map.dx(), -0.5 * map.dy()};
}

UniformGrid askedTrack(const DiskSurface& s)
{
    const auto axis = [](double length, double cell, double most) {
        return static_cast<int>(std::clamp(std::round(length / cell), 1.0, most));
    };
    const int nx = axis(s.track, s.cell, mostColumns), ny = axis(s.trackWidth, s.cell, mostRows);
    const double dx = s.track / nx, dy = s.trackWidth / ny;
    return {nx, ny, dx, dy, -0.5 * dx, -0.5 * dy};
}

} // namespace

DiskTopography::DiskTopography(const DiskSurface& surface, std::optional<HeightMap> file,
                               const std::function<bool()>& goOn)
{
    assert(diskSurfaceProblems(surface).empty());
    // What a flat disk or a measured one says of the track counts for nothing and may be anything.
    period_ = askedTrack(hasWaves(surface) || hasBumps(surface) ? surface : DiskSurface{});
    if (hasWaves(surface)) waves_ = Waves(surface);
    if (hasBumps(surface)) bumps_ = Bumps(surface);
    if (hasFile(surface) && file) {
        maps_.push_back(splineOf(*file));
        measured_ = gridOf(maps_.back());
        measured_.nx = file->nx;
        measured_.ny = file->ny;
        measuredRepeats_ = file->closedX && (file->closedY || file->ny == 1);
    }
    const bool fileAlone = !maps_.empty() && waves_.empty() && bumps_.empty() && !hasRoughness(surface);
    file.reset();
    if (hasRoughness(surface)) {
        std::vector<double> heights = generateRoughness(surface, goOn);
        if (!goOn || goOn())
            maps_.emplace_back(mapColumns(surface), mapRows(surface), surface.cell, surface.cell, std::move(heights));
    }

    highest_ = waves_.amplitude() + bumps_.highest();
    lowest_ = -waves_.amplitude() + bumps_.lowest();
    for (const PeriodicSpline& map : maps_) {
        highest_ += map.upperBound();
        lowest_ += map.lowerBound();
    }
    const auto finest = std::ranges::min_element(maps_, {}, &PeriodicSpline::dx);
    if (finest != maps_.end()) period_ = gridOf(*finest);
    // Bumps repeat with the generated map; with a measured one only by chance.
    repeats_ = waves_.empty() && maps_.size() < 2 && (bumps_.empty() || !hasFile(surface));
    if (!fileAlone) {
        measured_ = period_;
        measuredRepeats_ = repeats_;
    }
}

bool DiskTopography::flat() const { return waves_.empty() && maps_.empty() && bumps_.empty(); }

double DiskTopography::height(double x, double y) const
{
    double sum = waves_.height(x, y) + bumps_.height(x, y);
    for (const PeriodicSpline& map : maps_) sum += map.value(x, y);
    return sum;
}

double DiskTopography::upperBound(double x0, double x1, double y0, double y1) const
{
    double sum = waves_.upperBound(x0, x1, y0, y1) + bumps_.upperBound(x0, x1, y0, y1);
    for (const PeriodicSpline& map : maps_) sum += map.upperBound(x0, x1, y0, y1);
    return sum;
}

CurvatureBound DiskTopography::curvature(double x0, double x1, double y0, double y1) const
{
    CurvatureBound sum = waves_.curvature();
    sum += bumps_.curvature(x0, x1, y0, y1);
    for (const PeriodicSpline& map : maps_) sum += map.curvature(x0, x1, y0, y1);
    return sum;
}

DiskPoint DiskTopography::point(double x, double y) const
{
    DiskPoint at;
    waves_.addPoint(x, y, at);
    bumps_.addPoint(x, y, at);
    for (const PeriodicSpline& map : maps_) {
        const PeriodicSpline::Tangent tangent = map.tangent(x, y);
        at.height += tangent.value;
        at.slopeX += tangent.slopeX;
        at.slopeY += tangent.slopeY;
    }
    return at;
}

void DiskTopography::heights(const UniformGrid& grid, double shiftX, double shiftY, std::span<double> out) const
{
    std::ranges::fill(out, 0.0);
    for (const PeriodicSpline& map : maps_) map.addValues(grid, shiftX, shiftY, out);
    waves_.addHeights(grid, shiftX, shiftY, out);
    bumps_.addHeights(grid, shiftX, shiftY, out);
}

void DiskTopography::cellMeans(const CellGrid& grid, double shiftX, double shiftY, std::span<double> out) const
{
    std::vector<double> work;
    cellMeans(grid, shiftX, shiftY, out, work);
}

void DiskTopography::cellMeans(const CellGrid& grid, double shiftX, double shiftY, std::span<double> out,
                               std::vector<double>& work) const
{
    std::ranges::fill(out, 0.0);
    for (const PeriodicSpline& map : maps_) map.addMeans(grid, shiftX, shiftY, out, work);
    waves_.addMeans(grid, shiftX, shiftY, out);
    bumps_.addMeans(grid, shiftX, shiftY, out);
}

} // namespace touchdown
