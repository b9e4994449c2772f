// SPDX-License-Identifier: GPL-3.0-or-later
//
// This program as the second process that reads an HDF5 file or a drawing of another person:
// core/formats/reader_process.h.
#pragma once

#include <optional>

namespace touchdown {

/// The first call of main(): where this process is a reader it reads the file, sends its answer and returns the exit
/// code of the process; else nothing.
std::optional<int> runReader(int argc, const char* const* argv);

} // namespace touchdown
