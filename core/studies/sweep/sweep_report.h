// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a sweep shows: a table with a row for each point, curves over one axis, maps over two, clouds of samples with
// their rank correlations, and the range of each reading.
#pragma once

#include "core/studies/study/item_study.h"
#include "core/studies/sweep/sweep_task.h"

namespace touchdown {

/// A row holds a value for each reading of the task, then the problem of the item, "" for none.
StudyReport sweepReport(const SweepTask& task, const ItemRows& rows);

} // namespace touchdown
