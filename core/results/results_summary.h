// SPDX-License-Identifier: GPL-3.0-or-later
//
// The groups /events and /summary of a results file.
#pragma once

#include <vector>

#include "core/formats/hdf5_group.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

/// Writes status and message of the run, too. A figure that is not known is NaN; any other number that is not finite is
/// left out. Throws Hdf5Error. Hold a Hdf5Access around it.
void writeSummary(const Hdf5Group& file, const std::vector<Quantity>& quantities, const Summary& summary);

} // namespace touchdown
