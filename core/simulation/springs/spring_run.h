// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run of the model "springs": the case's integrator, its samples, and what follows from them.
#pragma once

#include "core/simulation/springs/spring_recorder.h"

namespace touchdown {

struct IntegrationResult;

/// Runs the integrator that the case names, from the model's initial state, with a step of `step` [s] if it is a
/// fixed-step one.
IntegrationResult integrateSprings(const SpringModel& model, const Case& c, double step, SpringRecorder& recorder);

/// Never throws for numerics: see Summary::status.
Summary runSprings(const Case& c, const RunCallback& callback, const RunOptions& options = {});

} // namespace touchdown
