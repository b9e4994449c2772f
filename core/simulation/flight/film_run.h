// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run of the model "film" in time: static state -> initial state -> steps -> samples. Steps are as long as their
// error allows: they grow far from contact and shrink where it begins; where the contact's law switches they end there.
// A step that fails is tried again with half its length, and a run whose steps fall below 1e-14 s ends with the last
// good state.
#pragma once

#include "core/case/case.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

std::vector<Quantity> filmQuantities(const Case& c);
/// Over the slider: gap and pressure of the film.
RecordedFields filmMaps(const Case& c);

Summary runFilm(const Case& c, const RunCallback& callback);

} // namespace touchdown
