// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measured surfaces in HDF5: see core/formats/height_map_file.h.
#pragma once

#include <filesystem>

#include "core/formats/surface_heading.h"
#include "core/physics/disk/height_map.h"

namespace touchdown {

/// Throws CmlError, a sentence, where the file is no surface. `key` holds the units of disk.surface.unit.
HeightMap readHeightMapHdf5(const std::filesystem::path& file, const ColumnUnits& key = {});

} // namespace touchdown
