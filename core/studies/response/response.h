// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forced motion: amplitude and phase of the springs over the frequency at which waves of the disk pass, up and down.
//
// One wave of the given amplitude replaces the surface of the case. Its frequency is f = v/l: the speed v of the disk
// is held and the length l changes, or with `wavelength` the length is held and the speed changes. The air springs of
// the model do not depend on the speed. With the speed held, the waves under pad, front and rear spring are in phase at
// some frequencies and opposed at others, so that the amplitude has maxima and minima besides the resonances.
//
// The first motion starts as the case says. Each frequency begins with the motion to which the one before has settled
// (settled_motion.h), up to the last frequency and then down again. Where both ways settle to different motions there
// are two states. Each range of them ends with a jump on the way up and one on the way down, which is located by
// halving the interval of its frequency.
//
// Beside it: amplitude and phase of small motions about the static state, as linear algebra gives them.
#pragma once

#include "core/studies/study/study.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;

StudyPerformance planResponse(StudyReader& reader);
StudyForm responseForm(const Case& c);

} // namespace touchdown
