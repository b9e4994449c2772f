// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cycles of sustained bouncing of springs or a linear film, and the value of a parameter at which they end.
//
// At `values` values between from and to, the case is run from `starts` starts: as the case says, then from a tenth, a
// hundredth, ... of that height above d_e at the static pitch (SliderOf). A run that bounces at its end is the start of
// Newton's method on the return map (bouncing_slider.h); the cycle is followed over the whole range, in both directions
// and through folds (cycle_branches.h). Cycles that no run reaches and that are on no such branch are not found.
//
// Each cycle has its frequency, amplitude, Floquet multipliers and its energy balance by part. The parameter may be
// several keys with commas between them: all take the same value, as the damping ratios of both air springs do.
//
// With the table [map] the study maps over two values whether the slider flies, is caught or bounces (bouncing_map.h).
// With that table and without parameter, from, to, values and crossings only the map is made.
#pragma once

#include "core/studies/study/item_study.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;

StudyWork planCycles(StudyReader& reader);
StudyForm cyclesForm(const Case& c);

} // namespace touchdown
