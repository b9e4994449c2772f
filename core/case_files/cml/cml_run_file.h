// SPDX-License-Identifier: GPL-3.0-or-later
//
// run.dat, the input file of the established static program: attitude, runs, air, load, grid, scheme. One kilogram of
// load is 9.80665 N. For comparisons, note two of its conventions:
//
//   with use_standard_air it uses its own standard air instead of the file's values; altitudes count only then
//   the arm of the air's shear is the slider's full thickness
#pragma once

#include <string>
#include <string_view>

#include "core/case_files/cml/cml_parameters.h"

namespace touchdown {

/// Puts the values of a run.dat into a film case.
void readCmlRun(std::string_view text, CmlParameters& parameters);

/// A run.dat of the case. Values that it cannot hold are replaced by the nearest possible value or the default;
/// `comments` are appended.
std::string formatCmlRun(const Case& c, std::string_view comments);

} // namespace touchdown
