// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/surface_sampling.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/numerics/moments.h"

namespace touchdown {
namespace {

constexpr int mostSampledColumns = 512, mostSampledRows = 256;

std::vector<double> heightsOn(const DiskTopography& surface, const UniformGrid& grid)
{
    std::vector<double> heights(grid.cells());
    surface.heights(grid, 0.0, 0.0, heights);
    return heights;
}

/// Cells of `step` from the first centre, as many as one period or `most` has; at least two.
int countOf(double period, double step, int most)
{
    return static_cast<int>(std::clamp(std::round(period / step), 2.0, static_cast<double>(most)));
}

/// The cells of `points` in the rectangle of `grid`.
UniformGrid within(const UniformGrid& points, const UniformGrid& grid)
{
    UniformGrid part = points;
    part.x0 += std::round((grid.x0 - points.x0) / points.dx) * points.dx;
    part.y0 += std::round((grid.y0 - points.y0) / points.dy) * points.dy;
    part.nx = std::clamp(static_cast<int>(std::lround(grid.nx * grid.dx / points.dx)), 1, points.nx);
    part.ny = std::clamp(static_cast<int>(std::lround(grid.ny * grid.dy / points.dy)), 1, points.ny);
    return part;
}

} // namespace

SurfaceSampling surfaceSampling(const DiskTopography& surface, const UniformGrid& grid)
{
    const UniformGrid period = surface.period();
    UniformGrid cells = grid;
    cells.nx = countOf(period.nx * period.dx, grid.dx, mostSampledColumns);
    cells.ny = countOf(period.ny * period.dy, grid.dy, mostSampledRows);
    const std::vector<double> centres = heightsOn(surface, cells);
    SurfaceSampling sampling;
    sampling.rms = momentsOf(centres).deviation;
    sampling.rmsOfMap = momentsOf(heightsOn(surface, within(period, cells))).deviation;

    const UniformGrid middles{
        cells.nx - 1, cells.ny - 1, cells.dx, cells.dy, cells.x0 + 0.5 * cells.dx, cells.y0 + 0.5 * cells.dy};
    const std::vector<double> between = heightsOn(surface, middles);
    double squares = 0.0;
    for (int j = 0; j < middles.ny; ++j)
        for (int i = 0; i < middles.nx; ++i) {
            const std::size_t low = cells.at(i, j), high = cells.at(i, j + 1);
            const double mean = 0.25 * (centres[low] + centres[low + 1] + centres[high] + centres[high + 1]);
            const double distance = between[middles.at(i, j)] - mean;
            squares += distance * distance;
        }
    sampling.unresolved = std::sqrt(squares / static_cast<double>(middles.cells()));
    return sampling;
}

double largestSeam(const DiskTopography& surface, const UniformGrid& grid)
{
    double seam = 0.0;
    const auto compare = [&](double x, double y, double beyondX, double beyondY) {
        seam = std::max(seam, std::abs(surface.height(x + beyondX, y + beyondY) - surface.height(x, y)));
    };
    for (int i = 0; i < grid.nx; ++i) compare(grid.x(i), grid.y(0), 0.0, grid.ny * grid.dy);
    for (int j = 0; j < grid.ny; ++j) compare(grid.x(0), grid.y(j), grid.nx * grid.dx, 0.0);
    return seam;
}

} // namespace touchdown
