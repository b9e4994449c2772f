// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the ladder showed: the advice with its claimed error and saving, what was left out, chart and tables.
#pragma once

#include "core/studies/advisor_study.h"
#include "core/studies/study.h"

namespace touchdown {

/// Whether what was claimed of one error came true: within a factor of two, or both below what the pilot could tell or a tenth of what is
/// allowed.
bool confirms(double claimed, double found, double resolution, double allowed);

/// Findings, warnings, charts, tables and the case that is advised.
void reportAdvice(const AdvisorTask& task, const AdvisorResult& result, StudyReport& report);

} // namespace touchdown
