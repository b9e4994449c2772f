// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run of the model "film" in time: static state -> initial state -> steps -> samples. The error of a step sets its
// length: long far from contact, short where it begins. A step ends where the contact's law switches. A step that fails
// is repeated with half its length; below 1e-14 s the run ends with the last good state.
#pragma once

#include "core/case/case.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

std::vector<Quantity> filmQuantities(const Case& c);
/// Over the slider: gap and pressure of the film.
RecordedFields filmMaps(const Case& c);

Summary runFilm(const Case& c, const RunCallback& callback, const RunOptions& options = {});

} // namespace touchdown
