// SPDX-License-Identifier: GPL-3.0-or-later
//
// What ridges that are narrower than a cell (core/physics/slider/edge_ridges.h) leave uncertain in the load.
//
// Two grids whose cells are both wider than a ridge agree about it, so their difference does not show its error. On
// sliders drawn at random (seeds 5000 to 5027, at 14 nm and at 7 nm), grids that begin to resolve the ridges find a
// load that differs as if the resistance of a ridge to the flow were known to about a seventh. So each edge counts with
// the change of the load that a wall wider by 15 % makes there, whatever the number of cells. To first order that is
//
//   dG = -lambda . dR,   J^T lambda = dG/dp
//
// with the change dR of the film's residual at the solved pressure, in the cells nearest to the edge. The changes of
// several edges may cancel, but their errors need not: their magnitudes add up. tests/bench/README.md has the measured
// errors.
#pragma once

#include <span>
#include <vector>

#include "core/numerics/small_matrix.h"
#include "core/physics/slider/edge_ridges.h"

namespace touchdown {

struct Case;
struct FilmLevel;

/// For each of these edges the uncertain force, pitch and roll torque about the slider's centre, with their signs [N],
/// [N m]; of a case with a fixed attitude the force alone. `level` is solved at its film's attitude.
std::vector<Vector3> ridgeErrors(const Case& c, FilmLevel& level, std::span<const RailEdge> edges);

} // namespace touchdown
