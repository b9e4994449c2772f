// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a case to the surface of its disk.
#pragma once

#include "core/physics/disk_topography.h"
#include "core/simulation/case.h"

namespace touchdown {

/// The file of disk.surface.file, from the folder of the case.
std::filesystem::path diskSurfaceFile(const Case& c);

/// `c` is valid: its file can be read.
DiskTopography diskTopography(const Case& c);

} // namespace touchdown
