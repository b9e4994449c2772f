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

/// Of a measured surface that may have been read in a wrong unit: an rms above 10 um, points more than 1 mm apart.
std::vector<DiskSurfaceProblem> heightMapWarnings(const HeightMap& map);

/// The parts of a surface; `combined` has all that are given.
bool hasWaves(const DiskSurface& surface);
bool hasRoughness(const DiskSurface& surface);
bool hasFile(const DiskSurface& surface);
bool hasBumps(const DiskSurface& surface);

} // namespace touchdown
