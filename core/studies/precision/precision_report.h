// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy against speed as sentences, a chart and tables.
#pragma once

#include <vector>

#include "core/studies/study/study.h"

namespace touchdown {

struct PrecisionRuns;
struct PrecisionTask;

StudyChart precisionChart(const PrecisionTask& task, const PrecisionRuns& runs);
/// "runs": one row for each setting. "front": what is on the Pareto front of error and time.
std::vector<StudyTable> precisionTables(const PrecisionTask& task, const PrecisionRuns& runs);
/// Adds to findings and warnings.
void tellPrecision(const PrecisionTask& task, const PrecisionRuns& runs, StudyReport& report);

} // namespace touchdown
