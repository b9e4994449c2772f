// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run of the model "contact": the pad moves from approach.start to approach.closest and back at constant speed
// within run.duration, without inertia. Each sample is a state found from the one before.
#pragma once

#include "core/case/case.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

/// The separation at a time of the run [m], and the time within the way in or out at which it is passed [s].
double padSeparation(const Case& c, double time);
double approachTime(const Case& c, double separation);
double retractionTime(const Case& c, double separation);

Summary runContact(const Case& c, const RunCallback& callback);

} // namespace touchdown
