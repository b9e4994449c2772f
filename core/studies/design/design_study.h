// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for a design (design.h) as a study: its task (design_task.h), its report, and the case that was found.
#pragma once

#include "core/studies/study/study.h"

namespace touchdown {

class StudyReader;

struct DesignStudy;
struct DesignTask;

StudyPerformance planDesign(StudyReader& reader);

/// The case that was found is in the report where all targets are reached.
StudyReport designReport(const DesignTask& task, const DesignStudy& study);

} // namespace touchdown
