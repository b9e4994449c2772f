// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a sweep varies and reads, from its file:
//
//   calculate = "run"              # run, steady or modes
//   keep = "rows"                  # all: also a results file of each run
//   [[axis]]
//   key = "springs.flying_height"  # any key of the case; keys = [...] that move together
//   from = "3 nm"                  # or values = ["3 nm", "5 nm"]
//   to = "9 nm"
//   count = 7
//   [[reading]]
//   quantity = "flying_height"
//   at = "end"
//   least = "6 nm"                 # limits, with which the report tells the share within them
//   [samples]                      # instead of a grid: points drawn over all axes
//   method = "sobol"
//   count = 64
//   by = "surface"                 # from a surface through few exact items: core/studies/sweep/sweep_surface.h
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/studies/runs/reading.h"
#include "core/studies/sweep/sample_points.h"
#include "core/studies/sweep/sweep_axis.h"

namespace touchdown {

class StudyReader;

struct SweepSamples {
    SampleMethod method = SampleMethod::Sobol;
    std::size_t count = 0;
    int seed = 1;
    bool bySurface = false; // drawn from a surface through the items of a design; else each is an item
};

/// What a reading is to lie within, both ends included [unit of the reading]; none: no limit at that end.
struct SweepLimits {
    std::optional<double> least{}, most{};
    bool any() const { return least || most; }
    /// A value that is not known lies within none.
    bool hold(double value) const { return value == value && !(least && value < *least) && !(most && value > *most); }
};

struct SweepTask {
    Case start;
    Calculation calculate = Calculation::Run;
    bool keepsRuns = false; // the row of an item has the name of the file of its run behind its readings
    std::vector<SweepAxis> axes;
    std::optional<SweepSamples> samples{};
    std::vector<Reading> readings;             // stated errors behind what they belong to
    std::vector<SweepLimits> limits{};         // one for each reading
    std::vector<std::vector<double>> points{}; // of samples: a share of the probability for each axis, 0..1
    std::vector<std::vector<double>> design{}; // of samples from a surface: the numbers of each item

    std::size_t count() const;
    /// A value for each axis. In a grid the last axis runs first.
    std::vector<SweepValue> valuesOf(std::size_t item) const;
    Case caseOf(std::size_t item) const;
};

SweepTask readSweep(StudyReader& reader);

} // namespace touchdown
