// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which share of samples lies within limits, and which tolerance costs most of it.
#pragma once

#include "core/studies/study/item_study.h"
#include "core/studies/sweep/sweep_task.h"

namespace touchdown {

class SweepPoints;

/// Adds to the report of a sweep what its limits say: the share of its points, of samples with a table, histograms.
void addYield(const SweepPoints& points, StudyReport& report);
/// The report of samples that are drawn from a surface.
StudyReport surfaceReport(const SweepTask& task, const ItemRows& rows);

} // namespace touchdown
