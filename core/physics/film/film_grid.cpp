// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_grid.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/physics/film/graded_axis.h"

namespace touchdown {

namespace {

constexpr std::size_t bins = 2048;

/// Positions of edges across the axis, weighted with their length against the slider's.
std::vector<AxisMark> edgeMarks(const AirBearingSurface& surface, int axis, double extent, double across)
{
    std::map<double, double> lengths;
    for (const Rail& rail : surface.rails)
        for (std::size_t k = 0; k < rail.points.size(); ++k) {
            const RailPoint& a = rail.points[k];
            const RailPoint& b = rail.points[(k + 1) % rail.points.size()];
            const double from = axis == 0 ? a.x : a.y, to = axis == 0 ? b.x : b.y;
            const double length = axis == 0 ? std::abs(a.y - b.y) : std::abs(a.x - b.x);
            if (std::abs(from - to) <= 1e-6 * extent) lengths[from] += length / across;
        }
    std::vector<AxisMark> marks;
    for (const auto& [position, length] : lengths)
        if (length > 0.02) marks.push_back({position, length});
    return marks;
}

/// Lines wished for by the rails: what of the other direction the edges near a position take.
std::vector<double> edgeDensity(const AirBearingSurface& surface, int axis, double extent, double across)
{
    std::vector<double> density(bins, 0.0);
    const double bin = extent / bins;
    for (const Rail& rail : surface.rails)
        for (std::size_t k = 0; k < rail.points.size(); ++k) {
            const RailPoint& a = rail.points[k];
            const RailPoint& b = rail.points[(k + 1) % rail.points.size()];
            double from = axis == 0 ? a.x : a.y, to = axis == 0 ? b.x : b.y;
            if (from > to) std::swap(from, to);
            const double length = (axis == 0 ? std::abs(a.y - b.y) : std::abs(a.x - b.x)) / across;
            const double first = std::clamp(from / bin - 1.0, 0.0, bins - 1.0),
                         last = std::clamp(to / bin + 1.0, 0.0, bins - 1.0);
            for (std::size_t m = static_cast<std::size_t>(first); m <= static_cast<std::size_t>(last); ++m)
                density[m] += length / (to - from + 3.0 * bin);
        }
    // Spread over two per cent of the axis.
    const double keep = std::exp(-1.0 / (0.02 * bins));
    std::vector<double> spread = density;
    for (std::size_t k = 1; k < bins; ++k) spread[k] = std::max(spread[k], keep * spread[k - 1]);
    for (std::size_t k = bins - 1; k-- > 0;) spread[k] = std::max(spread[k], keep * spread[k + 1]);
    return spread;
}

/// Mean of the density raised to a power, so that it is 1 on average.
void normalise(std::vector<double>& density, double power)
{
    double mean = 0.0;
    for (double& d : density) mean += d = std::pow(d, power);
    mean /= static_cast<double>(density.size());
    for (double& d : density) d = mean > 0.0 ? d / mean : 1.0;
}

/// Values of the cells between lines, at equal bins.
std::vector<double> byPosition(const std::vector<double>& lines, const std::vector<double>& values)
{
    const double extent = lines.back() - lines.front();
    std::vector<double> density(bins);
    std::size_t k = 0;
    for (std::size_t m = 0; m < bins; ++m) {
        const double x = lines.front() + (static_cast<double>(m) + 0.5) / bins * extent;
        while (k + 2 < lines.size() && lines[k + 1] < x) ++k;
        density[m] = values[k];
    }
    return density;
}

/// By position: sum over the other direction of |d2p/dx2|/p. An error of the pressure on its way downstream stays the
/// same part of it, so that parts count, not pascals.
std::vector<double> bendDensity(const CellGrid& grid, int axis, std::span<const double> pressure, double ambient)
{
    const int n = axis == 0 ? grid.nx() : grid.ny(), nAcross = axis == 0 ? grid.ny() : grid.nx();
    const std::vector<double>& lines = axis == 0 ? grid.x : grid.y;
    const std::vector<double>& acrossLines = axis == 0 ? grid.y : grid.x;
    const auto value = [&](int i, int j) {
        if (i < 0 || i >= n) return ambient;
        return pressure[static_cast<std::size_t>(axis == 0 ? j * n + i : i * nAcross + j)];
    };
    std::vector<double> centres;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) centres.push_back(0.5 * (lines[i] + lines[i + 1]));
    std::vector<double> bend(static_cast<std::size_t>(n), 0.0);
    for (int i = 0; i < n; ++i) {
        const std::size_t k = static_cast<std::size_t>(i);
        const double below = i > 0 ? centres[k] - centres[k - 1] : centres[k] - lines[k];
        const double above = i + 1 < n ? centres[k + 1] - centres[k] : lines[k + 1] - centres[k];
        for (int j = 0; j < nAcross; ++j) {
            const std::size_t a = static_cast<std::size_t>(j);
            const double p = value(i, j);
            const double second =
                ((value(i + 1, j) - p) / above - (p - value(i - 1, j)) / below) / (0.5 * (below + above));
            bend[k] += std::abs(second) / p * (acrossLines[a + 1] - acrossLines[a]);
        }
    }
    return byPosition(lines, bend);
}

/// By position: sum over the other direction of |dh/dx|/h where the gap is so small that the disk drags air through it:
/// there the air that a rail takes in is decided.
std::vector<double> slopeDensity(const CellGrid& grid, int axis, std::span<const double> gap, double draggedGap)
{
    const int n = axis == 0 ? grid.nx() : grid.ny(), nAcross = axis == 0 ? grid.ny() : grid.nx();
    const std::vector<double>& lines = axis == 0 ? grid.x : grid.y;
    const std::vector<double>& acrossLines = axis == 0 ? grid.y : grid.x;
    std::vector<double> slope(static_cast<std::size_t>(n), 0.0);
    for (int i = 0; i + 1 < n; ++i) {
        const std::size_t k = static_cast<std::size_t>(i);
        for (int j = 0; j < nAcross; ++j) {
            const std::size_t a = static_cast<std::size_t>(j);
            const auto h = [&](int m) {
                return std::max(1e-9, gap[static_cast<std::size_t>(axis == 0 ? j * n + m : m * nAcross + j)]);
            };
            const double h1 = h(i), h2 = h(i + 1), ratio = std::min(h1, h2) / draggedGap;
            const double relative = std::abs(h2 - h1) / (h1 + h2) / (0.5 * (lines[k + 2] - lines[k]));
            const double part = relative / (1.0 + ratio * ratio) * (acrossLines[a + 1] - acrossLines[a]);
            slope[k] += part;
            slope[k + 1] += part;
        }
    }
    return byPosition(lines, slope);
}

/// Lines on the edges; their density along an axis is density(axis, extent, extent across).
template <typename Density>
CellGrid gridOf(const AirBearingSurface& surface, double length, double width, int nx, int ny, const Density& density)
{
    const auto axis = [&](int which, double extent, double across, int n) {
        return gradedAxis({.start = 0.0,
                           .end = extent,
                           .density = density(which, extent, across),
                           .marks = edgeMarks(surface, which, extent, across)},
                          n);
    };
    return {axis(0, length, width, nx), axis(1, width, length, ny)};
}

} // namespace

CellGrid uniformGrid(double length, double width, int nx, int ny)
{
    CellGrid grid;
    for (int i = 0; i <= nx; ++i) grid.x.push_back(length * i / nx);
    for (int j = 0; j <= ny; ++j) grid.y.push_back(width * j / ny);
    return grid;
}

CellGrid gradedGrid(const AirBearingSurface& surface, double length, double width, int nx, int ny)
{
    return gridOf(surface, length, width, nx, ny, [&](int axis, double extent, double across) {
        std::vector<double> density = edgeDensity(surface, axis, extent, across);
        normalise(density, 1.0 / 3.0);
        for (double& d : density) d = 0.5 + 0.5 * d;
        return density;
    });
}

CellGrid adaptedGrid(const AirBearingSurface& surface, double length, double width, int nx, int ny,
                     const KnownFilm& known)
{
    return gridOf(surface, length, width, nx, ny, [&](int axis, double, double) {
        std::vector<double> density = bendDensity(known.grid, axis, known.pressure, known.ambient);
        normalise(density, 1.0 / 3.0);
        std::vector<double> slope = slopeDensity(known.grid, axis, known.gap, known.draggedGap);
        normalise(slope, 0.5);
        for (std::size_t k = 0; k < bins; ++k) density[k] = 0.1 + 0.45 * density[k] + 0.45 * slope[k];
        return density;
    });
}

double draggedGap(double viscosity, double speed, double length, double ambient)
{
    return std::sqrt(6.0 * viscosity * speed * 0.01 * length / ambient);
}

std::vector<double> transfer(const CellGrid& from, std::span<const double> field, double outline, const CellGrid& to)
{
    struct Place {
        int low;      // cell below, -1 for the outline
        double share; // of the cell above
    };
    const auto places = [](const std::vector<double>& lines, const std::vector<double>& targets) {
        const int n = static_cast<int>(lines.size()) - 1;
        const auto node = [&](int i) {
            if (i < 0) return lines.front();
            if (i >= n) return lines.back();
            return 0.5 * (lines[static_cast<std::size_t>(i)] + lines[static_cast<std::size_t>(i) + 1]);
        };
        std::vector<Place> result;
        int i = -1;
        for (std::size_t k = 0; k + 1 < targets.size(); ++k) {
            const double x = 0.5 * (targets[k] + targets[k + 1]);
            while (i + 1 < n && node(i + 1) <= x) ++i;
            result.push_back({i, std::clamp((x - node(i)) / (node(i + 1) - node(i)), 0.0, 1.0)});
        }
        return result;
    };
    const std::vector<Place> px = places(from.x, to.x), py = places(from.y, to.y);
    const auto value = [&](int i, int j) {
        if (i < 0 || j < 0 || i >= from.nx() || j >= from.ny()) return outline;
        return field[static_cast<std::size_t>(j * from.nx() + i)];
    };
    std::vector<double> result;
    result.reserve(to.cells());
    for (const Place& y : py)
        for (const Place& x : px)
            result.push_back(
                (1.0 - y.share) * ((1.0 - x.share) * value(x.low, y.low) + x.share * value(x.low + 1, y.low)) +
                y.share * ((1.0 - x.share) * value(x.low, y.low + 1) + x.share * value(x.low + 1, y.low + 1)));
    return result;
}

} // namespace touchdown
