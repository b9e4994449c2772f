// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges of rails that the grid of the film does not resolve: shorter than the cell where they lie.
#pragma once

#include <vector>

#include "core/physics/slider/surface_check.h"

namespace touchdown {

struct CellGrid;

/// One warning for each rail with such edges, at the middle of each. An edge is short where both of its extents, along
/// x and along y, are less than those of the cell at its middle. A row of short edges, as in a rounded corner, counts
/// as one curve: it is reported only where all of it is that short. The surface must be valid, the grid not empty.
std::vector<SurfaceProblem> shortEdges(const AirBearingSurface& surface, const CellGrid& grid);

} // namespace touchdown
