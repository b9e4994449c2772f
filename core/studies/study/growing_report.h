// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a study shows what it has found so far, and how it ends before its end.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "core/studies/study/study.h"

namespace touchdown {

/// Calls the callback, where there is one; with `report()` where there are news. False: stop.
template <class Report>
bool tellProgress(const StudyCallback& callback, StudyProgress progress, bool news, Report&& report)
{
    if (!callback) return true;
    std::optional<StudyReport> soFar;
    if (news) progress.soFar = &soFar.emplace(report());
    return callback(progress);
}

/// Findings are those of a whole study.
inline StudyReport withoutFindings(StudyReport report)
{
    report.findings.clear();
    return report;
}

/// Not completed; charts and tables show what there is.
inline StudyReport ended(StudyReport report, StudyStatus status, std::string message)
{
    report.status = status;
    report.message = std::move(message);
    return withoutFindings(std::move(report));
}

} // namespace touchdown
