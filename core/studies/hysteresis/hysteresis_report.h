// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings, charts and tables of a hysteresis study: whether the slider bounces by itself, touch-down, take-off, the
// loop between them, and how close to equilibria the runs came to rest.
#pragma once

#include <string>
#include <vector>

#include "core/studies/hysteresis/hysteresis_result.h"
#include "core/studies/study/study.h"

namespace touchdown {

std::vector<std::string> hysteresisFindings(const HeldSteps& task, const HysteresisResult& result);
StudyReport hysteresisReport(const HeldSteps& task, const HysteresisResult& result);

} // namespace touchdown
