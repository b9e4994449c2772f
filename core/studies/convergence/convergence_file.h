// SPDX-License-Identifier: GPL-3.0-or-later
//
// A convergence study on disk. HDF5:
//
//   /                        attributes format ("touchdown-convergence"), format_version, software_version, date,
//   title, status,
//                            message
//   /case/text, parameters   the input, as in a results file of a run
//   /levels/cell, cells, seconds, <quantity>   one element for each level, from coarse to fine
//   /observed/order, limit, error              one element for each quantity; an order that was not seen is 0
//   /observed/quantity                         their names
//
// CSV as RFC 4180: the levels.
#pragma once

#include <filesystem>
#include <string>

#include "core/studies/convergence/convergence.h"

namespace touchdown {

/// Each returns "" or the problem in one sentence.
std::string writeConvergence(const std::filesystem::path& file, const Case& c, const std::string& caseText,
                             const ConvergenceStudy& study);
std::string writeConvergenceCsv(const std::filesystem::path& file, const ConvergenceStudy& study);

} // namespace touchdown
