// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measured surfaces in HDF5: see core/formats/height_map_file.h.
#pragma once

#include <filesystem>

#include "core/physics/disk/height_map.h"

namespace touchdown {

/// Throws CmlError, a sentence, where the file is no surface.
HeightMap readHeightMapHdf5(const std::filesystem::path& file);

} // namespace touchdown
