// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy against speed as sentences, a chart and tables.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/studies/runs/trajectory_error.h"
#include "core/studies/study/study.h"

namespace touchdown {

struct PrecisionPoint;
struct PrecisionRuns;
struct PrecisionTask;

struct ErrorUnit {
    std::string si, displayed;
};
ErrorUnit unitOf(const PrecisionTask& task, ErrorMeasure measure);

/// The error that the chart shows; none of a run that failed or was not made.
std::optional<double> errorOf(const PrecisionTask& task, const PrecisionPoint& point);

/// The error that a run is worth: no less than the reference's uncertainty, and no less than those of finer settings of
/// its method, which show that a small error was luck.
std::optional<double> worthOf(const PrecisionTask& task, const PrecisionRuns& runs, const PrecisionPoint& point);
/// What the reference itself does not know, in the measure of the chart.
double uncertaintyOf(const PrecisionTask& task, const PrecisionRuns& runs);

/// Points than which no other costs as little and is worth as much, from the most accurate one to the cheapest; of
/// those that cost something.
std::vector<const PrecisionPoint*> paretoFront(const PrecisionTask& task, const PrecisionRuns& runs,
                                               const std::function<double(const PrecisionPoint&)>& cost);

StudyChart precisionChart(const PrecisionTask& task, const PrecisionRuns& runs);
/// "runs": one row for each setting. "front": what is on the Pareto front of error and time.
std::vector<StudyTable> precisionTables(const PrecisionTask& task, const PrecisionRuns& runs);
/// Adds to findings and warnings.
void tellPrecision(const PrecisionTask& task, const PrecisionRuns& runs, StudyReport& report);

} // namespace touchdown
