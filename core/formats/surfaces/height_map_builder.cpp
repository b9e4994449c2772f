// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/height_map_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/formats/cml_text.h"
#include "core/formats/decimal.h"
#include "core/formats/surfaces/surface_units.h"
#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

namespace {

constexpr double printedDigits = 0.02;  // of a step: so far off may a place be that was rounded when it was printed
constexpr double sameHeight = 1e-6;     // of the whole range: so alike are first and last point of a closed map
constexpr std::size_t fewestPoints = 4; // along the track

/// Whether two points are alike in all rows, from `a` and `b` on every `stride`.
bool alike(const std::vector<double>& heights, std::size_t a, std::size_t b, std::size_t stride, std::size_t count,
           double range)
{
    for (std::size_t k = 0; k < count; ++k)
        if (std::abs(heights[a + k * stride] - heights[b + k * stride]) > sameHeight * range) return false;
    return true;
}

} // namespace

bool MapAxis::holds(std::size_t i, double place) const { return std::abs(place - at(i)) <= printedDigits * step; }

MapAxis equalSteps(std::span<const double> places, std::span<const int> lines, const std::string& name, double unit)
{
    const auto line = [&](std::size_t i) { return lines.empty() ? 0 : lines[i]; };
    const std::size_t n = places.size();
    if (n < 2) throw CmlError(n == 0 ? 0 : line(0), "there must be two or more different " + name);
    for (std::size_t i = 1; i < n; ++i)
        if (!(places[i] > places[i - 1]))
            throw CmlError(line(i), name + " must ascend: " + inUnit(places[i], unit) + " comes after " +
                                        inUnit(places[i - 1], unit));
    const auto refuse = [&](std::size_t i, double needed) {
        throw CmlError(line(i), name + " must ascend in equal steps, without gaps: " + inUnit(places[i], unit) +
                                    " stands where " + inUnit(needed, unit) + " is needed");
    };
    // Compared with the first step, a gap is found where it is, not where its share of the mean step adds up.
    const double begun = places[1] - places[0];
    for (std::size_t i = 1; i < n; ++i)
        if (std::abs(places[i] - places[i - 1] - begun) > 0.5 * begun) refuse(i, places[i - 1] + begun);
    const MapAxis axis{n, places[0], (places[n - 1] - places[0]) / static_cast<double>(n - 1)};
    for (std::size_t i = 1; i < n; ++i)
        if (!axis.holds(i, places[i])) refuse(i, axis.at(i));
    return axis;
}

HeightMap builtMap(const MapAxis& x, const MapAxis& y, std::vector<double> heights)
{
    if (x.points < fewestPoints)
        throw CmlError(0, "a surface needs at least " + std::to_string(fewestPoints) + " points along the track, not " +
                              std::to_string(x.points));
    const bool finite = std::ranges::all_of(heights, [](double h) { return std::isfinite(h); });
    if (!finite || !std::isfinite(x.step) || !std::isfinite(y.step))
        throw CmlError(0, "holds numbers that are too large, or become so by their unit or scale");
    const auto [lowest, highest] = std::ranges::minmax_element(heights);
    const double range = *highest - *lowest;
    HeightMap map;
    std::size_t nx = x.points, ny = y.points;
    map.closedX = alike(heights, 0, nx - 1, nx, ny, range);
    map.closedY = ny > fewestPoints && alike(heights, 0, (ny - 1) * nx, 1, nx, range);
    if (map.closedY) heights.resize(--ny * nx);
    if (map.closedX) {
        for (std::size_t j = 0; j < ny; ++j)
            std::copy_n(heights.begin() + static_cast<std::ptrdiff_t>(j * nx), nx - 1,
                        heights.begin() + static_cast<std::ptrdiff_t>(j * (nx - 1)));
        heights.resize(--nx * ny);
    }
    const double images = (map.closedX ? 1.0 : 2.0) * (map.closedY || ny == 1 ? 1.0 : 2.0);
    if (images * static_cast<double>(heights.size()) > mostMapPoints)
        throw CmlError(0, "has " + std::to_string(heights.size()) +
                              " points; with the mirror images of a map that does not close, at most 64 million fit");
    map.nx = static_cast<int>(nx);
    map.ny = static_cast<int>(ny);
    map.dx = x.step;
    map.dy = y.step;
    map.heights = std::move(heights);
    return map;
}

std::string inUnit(double length, double unit) { return decimalText(length / unit, 0, 6) + " " + lengthSymbol(unit); }

} // namespace touchdown
