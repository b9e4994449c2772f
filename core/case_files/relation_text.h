// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kept distances and symmetries of a case file: core/case_files/surface_text.h has their form.
#pragma once

#include "core/formats/input_problem.h"
#include "core/formats/toml_document.h"
#include "core/physics/slider/air_bearing_surface.h"

#include <vector>

namespace touchdown {

inline constexpr std::size_t mostRelations = 1000; // of each kind

/// Reads them into a surface whose rails have been read. The problems name no file. A relation with a problem is in the
/// surface as far as it could be read.
std::vector<InputProblem> readRelations(const TomlDocument& toml, AirBearingSurface& surface);

} // namespace touchdown
