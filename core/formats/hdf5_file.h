// SPDX-License-Identifier: GPL-3.0-or-later
//
// HDF5 files. Hold a Hdf5Access around createHdf5File and openHdf5File and all that is done with what they return.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/formats/hdf5_group.h"

namespace touchdown {

class OutputLock;

/// Creates a file that keeps the order of creation; one that exists is a failure. Throws Hdf5Error.
Hdf5Group createHdf5File(const std::filesystem::path& file);
/// `flags`: H5F_ACC_RDONLY or H5F_ACC_RDWR. Throws Hdf5Error.
Hdf5Group openHdf5File(const std::filesystem::path& file, unsigned flags = H5F_ACC_RDONLY);

/// Lets `fill` write a file that appears whole or not at all (core/formats/output_file.h). Returns "" or the problem in
/// one sentence that begins "cannot write WHAT to NAME: ".
std::string writeHdf5File(const OutputLock& lock, const std::string& what,
                          const std::function<void(const Hdf5Group&)>& fill);

} // namespace touchdown
