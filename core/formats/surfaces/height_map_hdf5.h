// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measured surfaces in HDF5: see core/formats/surfaces/height_map_file.h, which reads them in a process of its own.
#pragma once

#include <filesystem>

#include "core/formats/passed_values.h"
#include "core/formats/surfaces/surface_units.h"
#include "core/physics/disk/height_map.h"

namespace touchdown {

/// Reads it in this process. Throws CmlError, a sentence, where the file is no surface. `key` holds the units of
/// disk.surface.unit.
HeightMap readHeightMapHdf5(const std::filesystem::path& file, const ColumnUnits& key = {});

void pass(auto& stream, Passed<HeightMap> auto& map)
{
    stream(map.nx, map.ny, map.dx, map.dy, map.closedX, map.closedY, map.heights);
}

} // namespace touchdown
