// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forced motion: amplitude and phase of the slider, on springs or on a linear film, over the frequency at which waves
// of the disk pass, up and down.
//
// One wave of the given amplitude replaces the surface of the case. Its frequency is f = v/l: the speed v of the disk
// is held and the length l changes, or with `wavelength` the length is held and the speed changes. Springs alone have
// that: they do not depend on the speed. With the speed held, the waves under pad, front and rear spring, or along the
// film, are in phase at some frequencies and opposed at others, so that the amplitude has maxima and minima besides the
// resonances.
//
// The first motion starts as the case says; on a film from the static state, displaced where the case says so. It is
// followed up to the last frequency and down again, in steps that are as short as the motion needs (followed_motion.h).
// Where it ends the slider jumps to another motion. The place of the end does not depend on the frequencies of the
// study. Where both ways differ there are two states. That both agree does not mean that there is one state only: other
// starts are spread over the range, and the motions that they reach are shown beside both ways (response_sweep.h). The
// report says how many starts were tried.
//
// Beside it: amplitude and phase of small motions about the static state, as linear algebra gives them.
#pragma once

#include "core/studies/study/study.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;
struct ResponseTask;

StudyPerformance planResponse(StudyReader& reader);
/// The springs of the task's case, over its waves.
void takeSprings(ResponseTask& task);
StudyForm responseForm(const Case& c);

} // namespace touchdown
