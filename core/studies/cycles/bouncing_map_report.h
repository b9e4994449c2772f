// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chart, tables and sentences of the map over two values (core/studies/cycles/bouncing_map.h).
#pragma once

#include <optional>
#include <vector>

#include "core/studies/cycles/bouncing_map.h"
#include "core/studies/study/study.h"

namespace touchdown {

/// W of the map's law at a point [J]; nothing where there is no case.
std::optional<double> workOfLaw(const BouncingMapTask& task, double x, double y);

/// Row by row, x runs first; findings where all cells are done.
StudyReport mapReport(const MarkedMapTask& task, const std::vector<MapCell>& cells);

} // namespace touchdown
