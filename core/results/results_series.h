// SPDX-License-Identifier: GPL-3.0-or-later
//
// One column of numbers that grows at its end, in a results file. Each function throws Hdf5Error. Hold a Hdf5Access
// around them.
#pragma once

#include <string>
#include <vector>

#include "core/formats/hdf5_access.h"

namespace touchdown {

inline constexpr unsigned resultsDeflateLevel = 2;

/// float64, one-dimensional, chunked, unlimited, shuffle + deflate.
Hdf5Handle createHdf5Series(hid_t group, const std::string& name);
hsize_t seriesLength(hid_t dataset);
/// Brings `to` to the length of `from`, whose beginning it holds. Compressed chunks go over as they are.
void copyMissingChunks(hid_t from, hid_t to);
/// Refuses a column that says to be longer than what is stored can hold.
std::vector<double> readSeries(hid_t dataset);
void appendToSeries(hid_t dataset, const std::vector<double>& values);

} // namespace touchdown
