// SPDX-License-Identifier: GPL-3.0-or-later
//
// dynamics.def, the established dynamic program's file: slider as a rigid body, suspension, start, time steps, solution
// and grid, the disk's surface and intermolecular forces (cml_disk_file.h). What it says of slider surfaces, track
// accessing, contact of statistical surfaces and shocks is named in warnings where it is switched on.
#pragma once

#include <string_view>

#include "core/case_files/cml/cml_parameters.h"

namespace touchdown {

/// Puts the values of a dynamics.def into a film case that has the slider of its rail.dat.
void readCmlDynamics(std::string_view text, CmlParameters& parameters);

} // namespace touchdown
