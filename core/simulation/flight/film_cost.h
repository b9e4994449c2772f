// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the parts of a film run took, as figures of its summary.
#pragma once

#include "core/simulation/flight/coupled_step.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

void addFigures(const CoupledCost& cost, Summary& summary);

} // namespace touchdown
