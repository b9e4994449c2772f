// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table [map] of a study of cycles: its keys, its runs side by side, and what it adds to the report.
#pragma once

#include <vector>

#include "core/studies/cycles/bouncing_map.h"
#include "core/studies/study/study.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;

struct MarkedMapTask : BouncingMapTask {
    bool marksByWork = false; // a mark or more stands where the law of the map has the W of its case
};

/// Nothing where there is a problem, which the reader collects. `starts` is the default of map.starts.
std::optional<MarkedMapTask> readBouncingMap(StudyReader& reader, int starts, double duration);
std::vector<StudyKey> bouncingMapKeys(const Case& c, double largestMeniscusForce);

/// Adds chart, tables, findings and warnings to the report; its status is no longer Completed where the map was stopped
/// or no run has an end.
void addBouncingMap(const MarkedMapTask& task, int jobs, const StudyCallback& callback, StudyReport& report);

} // namespace touchdown
