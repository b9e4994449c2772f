// SPDX-License-Identifier: GPL-3.0-or-later
//
// The study "sweep": any values of any case over lists, a grid or samples; what is read off each item stands in one
// table. An item that fails is a row with its reason.
#pragma once

#include <memory>

#include "core/studies/study/item_study.h"
#include "core/studies/sweep/sweep_form.h"

namespace touchdown {

class StudyReader;
struct SweepTask;

/// An item for each point of the task; another kind of study may have its own report of them.
ItemStudy sweepItems(const std::shared_ptr<const SweepTask>& task);

/// Reads the keys of the sweep; their problems are the reader's.
StudyWork planSweep(StudyReader& reader);

} // namespace touchdown
