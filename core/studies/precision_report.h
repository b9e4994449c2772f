// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy against speed as sentences, a chart and tables.
#pragma once

#include "core/studies/precision_runs.h"
#include "core/studies/study.h"

namespace touchdown {

/// "rk4, 10 ns".
std::string nameOf(const PrecisionTask& task, const PrecisionPoint& point);
/// The error that the chart shows; none of a run that failed or was not made.
std::optional<double> errorOf(const PrecisionTask& task, const PrecisionPoint& point);

/// Points than which no other is both as fast and as accurate, from the most accurate one to the fastest; errors below `uncertainty` count as
/// equal to it.
std::vector<const PrecisionPoint*> paretoFront(const PrecisionTask& task, const PrecisionRuns& runs, double uncertainty);

StudyChart precisionChart(const PrecisionTask& task, const PrecisionRuns& runs);
/// "runs": one row for each setting. "fastest": the fastest run within each power of ten of the error.
std::vector<StudyTable> precisionTables(const PrecisionTask& task, const PrecisionRuns& runs);
/// Adds to findings and warnings.
void tellPrecision(const PrecisionTask& task, const PrecisionRuns& runs, StudyReport& report);

} // namespace touchdown
