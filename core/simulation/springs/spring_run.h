// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run of the model "springs": the case's integrator, its samples, and what follows from them.
#pragma once

#include "core/simulation/recording/run_summary.h"

namespace touchdown {

struct Case;

/// Never throws for numerics: see Summary::status.
Summary runSprings(const Case& c, const RunCallback& callback, const RunOptions& options = {});

} // namespace touchdown
