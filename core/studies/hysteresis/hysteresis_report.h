// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/studies/study/study.h"

namespace touchdown {

struct HeldSteps;
struct HysteresisResult;

/// Findings, charts and tables of a hysteresis study.
StudyReport hysteresisReport(const HeldSteps& task, const HysteresisResult& result);

} // namespace touchdown
