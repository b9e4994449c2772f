// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is wrong with a disk surface, as sentences that name lengths in micrometres. The file is not looked at.
#pragma once

#include <string>
#include <vector>

#include "core/physics/disk/disk_surface.h"

namespace touchdown {

/// Of a generated map: 64 million points take 0.5 GB.
inline constexpr double mostMapPoints = 64e6;
inline constexpr std::size_t mostWaves = 1000;
inline constexpr std::size_t mostBumps = 10000;

struct DiskSurfaceProblem {
    std::string key;      // the field, as it is called under [disk.surface]: "correlation_length"
    std::string sentence; // "must be at least 0.25 um, one cell of the map"; the key stands before it
};

/// Of the parts that the kind uses; empty for a surface that DiskTopography can make.
std::vector<DiskSurfaceProblem> diskSurfaceProblems(const DiskSurface& surface);

/// Which parts a surface has; `combined` has all that are given.
bool hasWaves(const DiskSurface& surface);
bool hasRoughness(const DiskSurface& surface);
bool hasFile(const DiskSurface& surface);
bool hasBumps(const DiskSurface& surface);

} // namespace touchdown
