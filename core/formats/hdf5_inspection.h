// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an HDF5 file of another person may hold, checked before anything of it is read: the library opens other files
// that it names (external storage, external links, virtual datasets), loads programs for its filters, and takes the
// memory that it asks for. Hold a Hdf5Access around these functions.
#pragma once

#include <cstdint>
#include <string>

#include "core/formats/hdf5_group.h"

namespace touchdown {

/// Opens a dataset of a group whose numbers lie in this file, uncompressed or by the filters deflate, shuffle and
/// fletcher32, in pieces that fit into memory. Throws Hdf5Error for others.
Hdf5Dataset openForeignDataset(const Hdf5Group& group, const std::string& name);

/// Checks all groups and datasets of a file likewise, and that the datasets take at most `mostBytes` [byte] together.
/// Throws Hdf5Error.
void inspectHdf5File(const Hdf5Group& file, std::uintmax_t mostBytes);

} // namespace touchdown
