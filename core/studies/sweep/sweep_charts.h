// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves over one axis of a sweep, maps over two, clouds of samples.
#pragma once

#include <vector>

#include "core/studies/study/study.h"
#include "core/studies/sweep/sweep_points.h"

namespace touchdown {

std::vector<StudyChart> sweepCharts(const SweepPoints& points);

} // namespace touchdown
