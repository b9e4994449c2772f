// SPDX-License-Identifier: GPL-3.0-or-later
//
// Touch-down and take-off by moving one value of a case slowly there and back:
//
//   parameter = "springs.flying_height"   # any number of the case; a rail's, as in core/studies/runs/design_key.h
//   from = "14 nm"
//   to = "1 nm"
//   steps = 40          # from one end to the other, at each of which the value is held
//   hold = "2 ms"       # for so long
//   anew = false        # true: each value begins as the case says, not where the one before ended
//   equilibria = true   # trace them, too
//
// Each value begins where the one before ended: with that position over the disk, those velocities and that branch of
// the contact law; a film begins steady at that attitude, and what an elastic contact or an adhesion remembers is not
// taken along. The first value, and one after a run that failed, begins as the case says. Anew each one does, and there
// is no way back: so it is where the value belongs to the start itself (initial.*). Values at which the two ways end in
// different states are the hysteresis; touch-down and take-off are known to half of a step.
//
// Equilibria are found in all modes of the contact law and traced by continuation, with their folds, Hopf points and
// ends: of the spring model in core/simulation/equilibria/spring_equilibria.h, of a film under Ono and Yamane's
// characteristic in core/simulation/equilibria/film_branches.h. With the eigenvalues of small motions they answer
// "self-excited or forced?": where an equilibrium is unstable by an oscillation, or there is none and the slider
// bounces, bouncing needs no cause from outside; where all are stable, what starts near them fades.
#pragma once

#include <string>

#include "core/studies/study/study.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

/// Reads the study's keys; what is wrong, or why this case cannot be studied so, is added to the reader's problems.
StudyPerformance planHysteresis(StudyReader& reader);
/// Its keys with their defaults for a case.
StudyForm hysteresisForm(const Case& c);

} // namespace touchdown
