// SPDX-License-Identifier: GPL-3.0-or-later
//
// A map of stability as a chart, tables and sentences.
#pragma once

#include "core/studies/study/study.h"

namespace touchdown {

struct StabilityMap;
struct StabilityTask;

/// A panel for each method: its settings along x, the parameter along y.
StudyChart mapChart(const StabilityTask& task, const StabilityMap& map);
/// "runs", with the paper's criterion beside the true class; "references".
std::vector<StudyTable> mapTables(const StabilityTask& task, const StabilityMap& map);
/// Adds to findings and warnings.
void tellMap(const StabilityTask& task, const StabilityMap& map, StudyReport& report);

} // namespace touchdown
