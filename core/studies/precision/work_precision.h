// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy against speed: one case, run by several methods with several settings each, with the error and the time of
// every run (work-precision diagrams; as in Mazzia & Magherini, Test Set for IVP Solvers, 2008, and SciML's
// DiffEqDevTools).
//
// A method is any change of the case, with any key that it sweeps: integrators, steps, tolerances, grids, schemes,
// couplings and contact patches are compared by the same means. Physics that a setting leaves out counts as error.
//
// Errors are those of trajectory_error.h against a reference that the study proves (precision_runs.h). Where no two
// reference runs agree, the trajectory is not determined, and ensembles of starts are compared instead (ensemble.h).
// The time is the solver's own; for springs, without samples and statistics. It is the minimum and the median of
// several repeats after a warm-up run; timed runs run alone.
#pragma once

#include "core/studies/study/study.h"

namespace touchdown {

class StudyReader;

StudyPerformance planWorkPrecision(StudyReader& reader);

} // namespace touchdown
