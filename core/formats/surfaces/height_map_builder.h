// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers of a file to a height map: equal steps, lengths with units, maps that close. Throws CmlError, a sentence with
// its line, if the numbers do not make a map.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/physics/disk/height_map.h"

namespace touchdown {

/// Equally spaced places on one axis.
struct MapAxis {
    std::size_t points = 0;
    double first = 0.0; // [m]
    double step = 0.0;  // [m]

    double at(std::size_t i) const { return first + static_cast<double>(i) * step; }
    /// Whether a place in a file, printed with the usual number of digits, is that of point i.
    bool holds(std::size_t i, double place) const;
};

/// The axis of these places [m]; `lines` are their lines in the file, or empty. `name` is "x" or "y", `unit` that of
/// the file [m], for its refusals.
MapAxis equalSteps(std::span<const double> places, std::span<const int> lines, const std::string& name,
                   double unit = 1.0);

/// Heights [m] row by row, x fastest, all finite; y.points 1 for a profile.
HeightMap builtMap(const MapAxis& x, const MapAxis& y, std::vector<double> heights);

/// A length [m] in the unit of the file: "0.25 um".
std::string inUnit(double length, double unit);

} // namespace touchdown
