// SPDX-License-Identifier: GPL-3.0-or-later
//
// Touch-down and take-off: one value of a case moves slowly there and back, and is held at a number of steps.
//
// Each value starts from the end of the one before: its position over the disk, velocities and branch of the contact
// law. A film starts steady at that attitude; the memory of an elastic contact or an adhesion is not carried over. The
// first value, and one after a run that failed, starts as the case says. With anew = true each value does so, one way
// only; this is always so where the value belongs to the start itself (initial.*). Values at which the two ways end in
// different states are the hysteresis; touch-down and take-off are known to half a step.
//
// Equilibria are found in all modes of the contact law and traced by continuation, with their folds, Hopf points and
// ends: spring model core/simulation/equilibria/spring_equilibria.h, film under Ono and Yamane's characteristic
// core/simulation/equilibria/film_branches.h. The eigenvalues of small motions tell self-excited from forced bouncing:
// where an equilibrium is unstable by an oscillation, or there is none and the slider bounces, bouncing needs no
// external cause; where all are stable, small disturbances decay.
#pragma once

#include "core/studies/study/study.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;

StudyPerformance planHysteresis(StudyReader& reader);
StudyForm hysteresisForm(const Case& c);

} // namespace touchdown
