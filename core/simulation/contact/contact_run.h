// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run of the model "contact": the pad moves in and out (core/simulation/contact/pad_way.h) without inertia. Each
// sample is a state found from the one before.
#pragma once

#include "core/case/case.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

Summary runContact(const Case& c, const RunCallback& callback, const RunOptions& options = {});

} // namespace touchdown
