// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is wrong with an air bearing surface: sentences that name the rail, the wall profile and the point, counted from
// 1 as in the files.
#pragma once

#include <string>
#include <vector>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

struct SurfaceProblem {
    std::string key;      // of a case file: "abs.rail[3]", "abs.wall[1]", else "abs"
    std::string sentence; // "Rail 3 has no area."
};

/// What leaves the recess undefined; empty for a surface that can be used.
std::vector<SurfaceProblem> surfaceProblems(const AirBearingSurface& surface);

/// What is defined but may not be meant, on a slider of this length and width [m]; for a surface without problems.
std::vector<SurfaceProblem> surfaceWarnings(const AirBearingSurface& surface, double length, double width);

} // namespace touchdown
