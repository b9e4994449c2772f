// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rungs of the ladder that have no film in time: what each says of the end of a run, at what cost.
#pragma once

#include "core/simulation/small_motions/linear_motion.h"
#include "core/studies/advice/advisor_study.h"
#include "core/studies/runs/parallel.h"

namespace touchdown {

/// Of a rung that is not of kind Full, Part or Sum. Of several places to rest in contact it is the one nearest to
/// `end`, the full model's spacing [m].
RungOutcome solveReduced(const Rung& rung, double end, const GoOn& goOn);

/// The same of small motions that are known, and took `seconds` of a processor.
RungOutcome describeSmallMotion(const Rung& rung, const LinearMotion& motion, double seconds);

} // namespace touchdown
