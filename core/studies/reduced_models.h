// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rungs of the ladder that have no film in time: what each says of the end of a run, at what cost.
#pragma once

#include "core/studies/advisor_study.h"
#include "core/studies/parallel.h"

namespace touchdown {

/// Of a rung of kind Static, WaveAnswer, SmallMotion or Springs.
RungOutcome solveReduced(const Rung& rung, const GoOn& goOn);

} // namespace touchdown
