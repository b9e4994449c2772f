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
//   end = ["contact"]                   # ... or how it ends: one of these ends,
//   motion = ["at rest", "settles"]     # one of these motions (core/simulation/recording/motion_verdict.h), or
//   like_end = "same"                   # "same" or "other": as the case `like` does, or otherwise
//   spread = "0.4 nm"                   # and the share of starts within that much around the case's own
//   remark = "why the run ends otherwise"
//   against = { "ono_yamane.take_off" = "4 nm" } # changes with which it must not hold
//
// Where a quantity is taken: over the last tenth of the run `end` is its mean, `swing` is peak to peak, and `rms` is
// its standard deviation. `mean` is the mean over the whole run: of a power, the work divided by the duration. `least`
// and `greatest` are its extremes over the whole run, between samples too, also of a run that fails. With a case `like`
// (and the changes `like_set`) these are differences: the run's less that of `like`; `difference` is another word for
// `end`. `distance` is the largest distance of the two at any time: both have the same duration, and samples at the
// same times. `peak` is the frequency of a peak in the power spectrum of the minimum spacing, `peaks` the number of
// peaks `from` a frequency `to` another one with at least a tenth of the largest amplitude at any frequency, and
// `likeness` tells how far the spectra of the run and of `like` have the same shape, from 0 to 1 (Bhattacharyya's
// coefficient). `case` is a number of the case itself.
//
// A check is worth what it refuses. With the option `contradict` each statement's case is run with its changes
// `against`, and every statement that holds then proves nothing.
//
// A trajectory that lands in one of two states by a hair proves little. A statement with a `spread` holds where more
// than half of an ensemble of `starts` does what it says; its share stands with Wilson's interval
// (core/studies/runs/ensemble.h). All others hold where the run of the case itself does.
//
// [[candidate]] changes all cases together, before each statement's own `set`; then each statement is checked with each
// candidate: a search for lost values.
#pragma once

#include "core/studies/study/item_study.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;

StudyWork planStatements(StudyReader& reader);
StudyForm statementsForm(const Case& c);

} // namespace touchdown
