// SPDX-License-Identifier: GPL-3.0-or-later
//
// The head of every HDF5 file of the program: attributes format, format_version, software_version, date and title; the
// group /case with the text of the case and every parameter that its model uses. Where nothing else is said, functions
// throw Hdf5Error; hold a Hdf5Access around them.
#pragma once

#include <filesystem>
#include <string>

#include "core/case/case.h"
#include "core/formats/hdf5_group.h"

namespace touchdown {

/// The time now as ISO 8601, in UTC.
std::string dateNow();

void writeFileHeader(const Hdf5Group& file, const std::string& format, int major, int minor, const std::string& date,
                     const std::string& title);

void writeCaseGroup(const Hdf5Group& file, const Case& c, const std::string& text);

/// Why a file cannot be opened as HDF5 at all, in a sentence; "" if it can. Throws nothing.
std::string notHdf5(const std::filesystem::path& path);
/// Why an open file is not of this format, or of a version that this program cannot read, in a sentence; "" if it can.
/// `what` is in it: "the results of a run".
std::string foreignFile(const std::filesystem::path& path, const Hdf5Group& file, const std::string& format, int major,
                        const std::string& what);
/// The format that an HDF5 file says it has; "" if it says none, or is none. Throws nothing, takes a Hdf5Access itself.
/// The first reads it in a process of its own (core/formats/reader_process.h).
std::string formatOf(const std::filesystem::path& path);
std::string formatDirectly(const std::filesystem::path& path);

} // namespace touchdown
