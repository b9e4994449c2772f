// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/disk_setup.h"

namespace touchdown {

std::filesystem::path diskSurfaceFile(const Case& c) { return c.folder / c.diskSurface.file; }

DiskTopography diskTopography(const Case& c) { return DiskTopography(c.diskSurface); }

} // namespace touchdown
