// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ranges of a parameter over which equilibria have a property.
#pragma once

#include <functional>
#include <vector>

#include "core/studies/hysteresis/hysteresis_result.h"
#include "core/studies/hysteresis/value_ranges.h"

namespace touchdown {

/// Where points of lines within the model have a property: neighbours along a line are one range, which reaches to a
/// fold or Hopf point next to it.
std::vector<ValueRange> rangesAlong(const std::vector<EquilibriumLine>& lines,
                                    const std::function<bool(const StudiedEquilibrium&)>& isSo);

/// Where more than one equilibrium is stable or neutral, interpolated between the points of the lines.
std::vector<ValueRange> coexistence(const std::vector<EquilibriumLine>& lines);

} // namespace touchdown
