// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of advice: the advice with its claimed error and saving, what was left out, chart and tables.
#pragma once

#include "core/studies/advice/advisor_study.h"
#include "core/studies/study/study.h"

namespace touchdown {

/// Findings, warnings, charts, tables and the case that is advised.
void reportAdvice(const AdvisorTask& task, const AdvisorResult& result, StudyReport& report);

} // namespace touchdown
