// SPDX-License-Identifier: GPL-3.0-or-later
//
// Problems of a disk surface, as sentences with lengths in micrometres. The file is not read.
#pragma once

#include <string>
#include <vector>

#include "core/physics/disk/disk_surface.h"
#include "core/physics/disk/height_map.h"

namespace touchdown {

/// Of a generated map: 64 million points take 0.5 GB.
inline constexpr double mostMapPoints = 64e6;
inline constexpr std::size_t mostWaves = 1000;
inline constexpr std::size_t mostBumps = 10000;

struct DiskSurfaceProblem {
    std::string key;      // the key's name under [disk.surface]: "correlation_length"
    std::string sentence; // follows the key: "must be at least 0.25 um, one cell of the map"
};

/// Of the parts that the kind uses; empty for a surface that DiskTopography accepts.
std::vector<DiskSurfaceProblem> diskSurfaceProblems(const DiskSurface& surface);

/// Of a measured surface that was read in a wrong unit: an rms slope above 1. A disk has less than 0.1; swapped units
/// of um and nm give a million times its slope.
std::vector<DiskSurfaceProblem> heightMapProblems(const HeightMap& map);
/// Of one that may have been: an rms slope above 0.1, an rms above 10 um, points more than 1 mm apart.
std::vector<DiskSurfaceProblem> heightMapWarnings(const HeightMap& map);
/// The larger of the rms slopes along x and y, between neighbouring points [-].
double rmsSlope(const HeightMap& map);

/// The parts of a surface; `combined` has all that are given.
bool hasWaves(const DiskSurface& surface);
bool hasRoughness(const DiskSurface& surface);
bool hasFile(const DiskSurface& surface);
bool hasBumps(const DiskSurface& surface);

} // namespace touchdown
