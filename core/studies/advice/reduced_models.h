// SPDX-License-Identifier: GPL-3.0-or-later
//
// The candidates without a film in time: the end of the run that each predicts, and its cost.
#pragma once

#include "core/work/parallel.h"

namespace touchdown {

struct Candidate;
struct CandidateOutcome;
struct LinearMotion;

/// `candidate` is not of kind Full, Part or Sum. Where there are several equilibria in contact, the result is the one
/// nearest to `end`, the spacing of the full model [m].
CandidateOutcome solveReduced(const Candidate& candidate, double end, const GoOn& goOn);

/// The same of small motions that were computed already, in `seconds` of a processor.
CandidateOutcome describeSmallMotion(const Candidate& candidate, const LinearMotion& motion, double seconds);

} // namespace touchdown
