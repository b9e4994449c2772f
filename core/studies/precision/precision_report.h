// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy against speed as sentences, a chart and tables.
#pragma once

#include "core/studies/study/study.h"

namespace touchdown {

struct PrecisionRuns;
struct PrecisionTask;

StudyChart precisionChart(const PrecisionTask& task, const PrecisionRuns& runs);
/// With the tables "runs", one row for each setting, and "front", what is on the Pareto front of error and time.
StudyReport precisionReport(const PrecisionTask& task, const PrecisionRuns& runs);

} // namespace touchdown
