// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is what a text says of a slider true of the program's run? The study's file quotes sentences and numbers, names the
// run of each one, and says what must come out.
//
//   [[statement]]
//   figure = "Fig. 12 a"
//   quote = "The FH of the steady state is 1.6 nm."
//   case = "fig12a"                     # default: the study's case
//   set = { "run.duration" = "2 ms" }   # on it
//   quantity = "flying_height"          # either a number of the run ...
//   at = "end"
//   at_least = "1.55 nm"
//   at_most = "1.65 nm"
//
//   [[statement]]
//   figure = "Fig. 8"
//   quote = "With an initial FH of 20 nm, the slider contacts the disk in the steady state."
//   case = "fig08_start_20nm"
//   end = ["contact"]                   # ... or how it ends: one of these
//   spread = "0.4 nm"                   # and the share of starts within that much around the case's own
//   remark = "why the run ends otherwise"
//
// Where a quantity is taken: `end` is its mean over the last tenth of the run and `swing` its standard deviation there,
// `least` and `greatest` are its extremes over the whole run, also of one that fails. `difference` is its mean over the
// last tenth less that of the case `like` (with the changes `like_set`), `distance` the largest distance of the two at
// any time. `peak` is the frequency of a peak in the power spectrum of the minimum spacing.
//
// A trajectory that lands in one of two states by a hair proves little. A statement with a `spread` holds where more
// than half of an ensemble of `starts` does what it says; its share stands with Wilson's interval
// (core/studies/precision/ensemble.h). All others hold where the run of the case itself does.
//
// [[candidate]] changes all cases together, before each statement's own `set`; then each statement is checked with each
// candidate: a search for lost values.
#pragma once

#include "core/studies/study/study.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;

StudyPerformance planStatements(StudyReader& reader);
StudyForm statementsForm(const Case& c);

} // namespace touchdown
