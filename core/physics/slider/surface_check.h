// SPDX-License-Identifier: GPL-3.0-or-later
//
// Problems of an air bearing surface: sentences that name rail, wall profile and point, counted from 1 as in the files.
#pragma once

#include <string>
#include <vector>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

struct SurfaceProblem {
    std::string key;                    // of a case file: "abs.rail[3]", "abs.wall[1]", else "abs"
    std::string sentence;               // "Rail 3 has no area."
    std::vector<SurfacePoint> places{}; // on the surface, where it has any: corners, or where an outline crosses itself
};

/// Problems that leave the recess undefined; empty for a valid surface.
std::vector<SurfaceProblem> surfaceProblems(const AirBearingSurface& surface);

/// Defined but probably unintended, on a slider of this length and width [m]; for a surface without problems.
std::vector<SurfaceProblem> surfaceWarnings(const AirBearingSurface& surface, double length, double width);

} // namespace touchdown
