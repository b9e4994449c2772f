// SPDX-License-Identifier: GPL-3.0-or-later
//
// The static state of a case that was changed a little, from that of the case before: for a shape that is being drawn.
#pragma once

#include <optional>
#include <vector>

#include "core/simulation/static_state/steady.h"

namespace touchdown {

/// From the pressure and the attitude of `from`, the state of `before`, and on its grid, whose lines move with the
/// edges of rails that they lie on, so that a change of the state is that of the case and not of the grid. For the
/// attitude alone: without stiffness, sensitivities, other equilibria and the error of the grid. Where `from` has no
/// state, the attitude is held, the slider has another size, lines would pass each other, or no state is found nearby:
/// as `steady`.
SteadyResult steadyNear(const Case& c, const Case& before, const SteadyResult& from,
                        const SteadyCallback& callback = {});

/// The grid with its lines on the edges as they are now. Nothing where corners came or went, or lines would pass each
/// other.
std::optional<CellGrid> movedGrid(const CellGrid& grid, const AirBearingSurface& before, const AirBearingSurface& now);

/// The borders of cells along one axis, those at `from` moved to `to` (as many, in any order), those between evenly
/// with them; nothing where two would pass each other or come closer than half of what they were apart.
std::optional<std::vector<double>> movedLines(const std::vector<double>& lines, const std::vector<double>& from,
                                              const std::vector<double>& to);

} // namespace touchdown
