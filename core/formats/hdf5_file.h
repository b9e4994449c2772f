// SPDX-License-Identifier: GPL-3.0-or-later
//
// An HDF5 file that is there whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/formats/hdf5_access.h"

namespace touchdown {

/// Lets `fill` write NAME.part, which then takes the place of NAME; a link stays a link. Returns "" or the problem in
/// one sentence that begins "cannot write WHAT to NAME: "; what was there before is then as it was.
std::string writeHdf5File(const std::filesystem::path& file, const std::string& what,
                          const std::function<void(hid_t)>& fill);

} // namespace touchdown
