// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of advice: the advice with its claimed error and saving, what was left out, chart and tables.
#pragma once

namespace touchdown {

struct AdvisorResult;
struct AdvisorTask;
struct StudyReport;

/// Findings, warnings, charts, tables and the case that is advised.
void reportAdvice(const AdvisorTask& task, const AdvisorResult& result, StudyReport& report);

} // namespace touchdown
