// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of a chart as comma-separated values.
#pragma once

#include <QIODevice>

#include "core/studies/study/study.h"

namespace touchdown {

/// A row for each point of a series and each cell of a map: number of the panel, name of the series or class, label,
/// how the point came out, x and y in the units of the axes (SI), which the head of each panel names.
void writeChartCsv(const StudyChart& chart, QIODevice& device);

} // namespace touchdown
