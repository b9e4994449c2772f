// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table [map] of a study of cycles: its keys, its runs side by side, and what it adds to the report.
#pragma once

#include <vector>

#include "core/studies/cycles/bouncing_map.h"
#include "core/studies/study/item_study.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;

/// Nothing where there is a problem, which the reader collects. `starts` is the default of map.starts.
std::optional<MarkedMapTask> readBouncingMap(StudyReader& reader, int starts, double duration);
std::vector<StudyKey> bouncingMapKeys(const Case& c, double largestMeniscusForce);

/// An item for each cell; x runs first. Its row: W, the number of runs by BouncingEnd, the problem of a run that
/// failed.
ItemStudy bouncingMapItems(const MarkedMapTask& task);

} // namespace touchdown
