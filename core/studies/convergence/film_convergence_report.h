// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings, charts and tables of a study of films over their grids.
#pragma once

#include "core/studies/convergence/film_convergence.h"
#include "core/studies/study/study.h"

namespace touchdown {

StudyReport filmConvergenceReport(const FilmConvergenceTask& task, const FilmConvergence& study);

} // namespace touchdown
