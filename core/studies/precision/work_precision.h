// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy against speed: one case, run by several methods with several settings each, with the error and the time of
// every run (work-precision diagrams; as in Mazzia & Magherini, Test Set for IVP Solvers, 2008, and SciML's
// DiffEqDevTools).
//
// A method is any change of the case together with any key that it sweeps. Integrators, steps, tolerances, grids,
// schemes, slip paths, couplings and contact patches are therefore all compared by the same means. The effect of
// physics that a setting leaves out counts as error, too.
//
// Errors are those of trajectory_error.h against a reference that the study proves (precision_runs.h): two finer runs
// of different families that agree. Where no two agree the trajectory is not determined, and ensembles of starts are
// compared instead (ensemble.h). The time is the solver's own, without samples and statistics for springs.
// It is given as the minimum and the median of several repeats after a warm-up run; timed runs run alone.
//
//   case = "fig10a"
//   of = "run"                  # film: or "static", the static state
//   quantity = "flying_height"  # of which the errors are computed; default: the spacing
//   error = "worst"             # in the chart: final, l2, worst, mean, deviation, peak-frequency, peak-amplitude
//   repeats = 5
//   time_limit = "0.1 s"        # runs that take longer are timed once
//   budget = "15 s"             # of wall time: runs that have not started when it is spent are left out;
//                               # up to 60 % of it for the references
//   agreement = "0.1 nm"        # largest difference of the two best references
//
//   [[method]]                  # see swept_method.h; the case's own value is added to the case's own method;
//   ...                         # default: methods that suit the model, see precision_methods.h
//
//   [[reference]]               # two or more; default: references that suit the model
//   name = "finer"
//   set = { "run.tolerance" = 1e-13 }
//
//   [ensemble]                  # default: for springs, where the trajectory is not determined
//   starts = 300
//   spread = "0.5 nm"           # around the case's own start, evenly
//   key = "initial.flying_height"
//   set = { "run.tolerance" = 1e-12 } # the reference ensemble
#pragma once

#include <string>

#include "core/studies/study/study.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

/// Reads the study's keys; what is wrong, or why this case cannot be studied so, is added to the reader's problems.
StudyPerformance planWorkPrecision(StudyReader& reader);
/// Its keys with their defaults for a case.
StudyForm workPrecisionForm(const Case& c);

} // namespace touchdown
