// SPDX-License-Identifier: GPL-3.0-or-later
//
// run.dat, the established static program's file of what is computed: attitude, runs, air, load, grid, scheme. Its
// kilograms of load are 9.80665 N. What it does with a file that matters for a comparison:
//
//   with use_standard_air it takes its own standard air, whatever the file says; altitudes count only then
//   the arm of the air's shear is the slider's full thickness
#pragma once

#include <string>
#include <string_view>

#include "core/case_files/cml/cml_fields.h"

namespace touchdown {

/// Puts what a run.dat says into a film case.
void readCmlRun(std::string_view text, CmlFields& fields);

/// A run.dat of the case. What it has no place for has the nearest value that it has, or its default; `comments` go to
/// the end.
std::string formatCmlRun(const Case& c, std::string_view comments);

} // namespace touchdown
