// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walls that run into each other, so that neither reaches its foot: outside two rails or in a notch of one, where the
// gap is narrower than both walls together, and inside a rail that is narrower than the inner parts of its walls.
//
//   \      /           two walls end at the base      \    /        the gap between them is too narrow
//    \____/                                             \/
#pragma once

#include <vector>

#include "core/physics/slider/surface_check.h"

namespace touchdown {

/// One warning for each rail with walls that meet others of it, and for each two rails whose walls meet; at the middle
/// of each place. Walls meet where their areas overlap, their edges face each other (more than 120 degrees between the
/// normals), and no top of a rail covers the place. The surface must be valid.
std::vector<SurfaceProblem> meetingWalls(const AirBearingSurface& surface);

} // namespace touchdown
