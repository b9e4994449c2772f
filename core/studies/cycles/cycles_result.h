// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a study of cycles has found: its runs, the branches of cycles, and where a stable cycle ends.
#pragma once

#include <string>
#include <vector>

#include "core/case/case_key.h"
#include "core/studies/cycles/bouncing_run.h"
#include "core/studies/cycles/cycle_branches.h"
#include "core/studies/runs/value_ranges.h"

namespace touchdown {

struct CyclesTask {
    Case start;
    Parameter parameter; // sets all keys
    ParameterText text;
    double from = 0.0, to = 1.0; // [unit of the parameter]
    std::vector<double> values;  // at which runs start, there [unit of the parameter]
    int starts = 3;
    BouncingSearch search;
    SliderOf sliderOf;
};

struct CyclesResult {
    std::vector<BouncingRun> runs; // that have ended, by value, then by start
    std::vector<CycleBranch> branches;
};

/// Where the branches are stable.
std::vector<ValueRange> stableRanges(const std::vector<CycleBranch>& branches);

/// Where W < 0, among the values between from and to: the contact law creates energy there. Values that are not valid
/// for the case are left out.
std::vector<ValueRange> creatingRanges(const CyclesTask& task);

/// A mark at which a stable part of a branch ends.
struct CycleThreshold {
    MarkedCycle mark;
    std::size_t branch = 0;
};
std::vector<CycleThreshold> thresholdsOf(const std::vector<CycleBranch>& branches);

/// The largest differences between bouncing runs and the stable cycles that Newton's method found from them [-].
struct CycleAgreement {
    std::size_t runs = 0;
    double frequency = 0.0, amplitude = 0.0;
};
CycleAgreement agreementOf(const std::vector<BouncingRun>& runs);

} // namespace touchdown
