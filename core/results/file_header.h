// SPDX-License-Identifier: GPL-3.0-or-later
//
// The head of every HDF5 file of the program: attributes format, format_version, software_version, date and title; the
// group /case with the text of the case and every parameter that its model uses. Each function throws Hdf5Error. Hold a
// Hdf5Access around them.
#pragma once

#include <string>

#include "core/case/case.h"
#include "core/formats/hdf5_group.h"

namespace touchdown {

/// The time now as ISO 8601, in UTC.
std::string dateNow();

void writeFileHeader(const Hdf5Group& file, const std::string& format, int major, int minor, const std::string& date,
                     const std::string& title);

void writeCaseGroup(const Hdf5Group& file, const Case& c, const std::string& text);

} // namespace touchdown
