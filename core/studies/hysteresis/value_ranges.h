// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where along a parameter something holds, and how a sentence tells it: "at 3 nm", "from 3 nm to 5 nm and at 8 nm".
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/studies/hysteresis/hysteresis_result.h"

namespace touchdown {

struct ValueRange {
    double lower = 0.0, upper = 0.0; // [unit of the parameter]
};

/// By their lower ends; those that meet are one.
std::vector<ValueRange> merged(std::vector<ValueRange> ranges);

/// Of `chosen` among all values: neighbours are one range.
std::vector<ValueRange> rangesAmong(std::vector<double> all, std::vector<double> chosen);

/// Where points of lines within the model are so: neighbours along a line are one range, which reaches to a fold or
/// Hopf point next to it.
std::vector<ValueRange> rangesAlong(const std::vector<EquilibriumLine>& lines,
                                    const std::function<bool(const StudiedEquilibrium&)>& isSo);

/// Where more than one equilibrium is stable or neutral, between the points of the lines.
std::vector<ValueRange> coexistence(const std::vector<EquilibriumLine>& lines);

std::string text(const std::vector<ValueRange>& ranges, const ParameterText& parameter);

} // namespace touchdown
