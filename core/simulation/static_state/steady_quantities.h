// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of a static state by name, with units: as in JSON, the results file and tables of a series.
#pragma once

#include <string>
#include <vector>

#include "core/simulation/recording/progress.h"
#include "core/simulation/recording/quantity.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown {

/// A number of a state. It may be NaN: what could not be computed.
struct SteadyQuantity {
    Quantity quantity;
    double value = 0.0; // SI
};

/// All numbers that are one value each, in the order of the report.
std::vector<SteadyQuantity> steadyQuantities(const SteadyResult& result);

/// Sets the number with this name, as read from a file; other names do nothing.
void setSteadyQuantity(SteadyResult& result, const std::string& name, double value);

/// What sets the states of a series apart: radius, skew, speed and, if any, altitude.
std::vector<SteadyQuantity> seriesQuantities(const SteadySeriesPoint& point);

/// Of a static solution. The number of its iterations is not known beforehand, so there is no share.
Progress progressOf(const SteadyProgress& update);

} // namespace touchdown
