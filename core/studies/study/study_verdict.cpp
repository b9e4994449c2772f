// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study_verdict.h"

#include <algorithm>

#include "core/studies/study/study.h"

namespace touchdown {

StudyVerdict verdictOf(const StudyReport& report)
{
    if (report.status == StudyStatus::Completed && report.findings.empty()) return StudyVerdict::None;
    if (report.tables.empty()) return StudyVerdict::None;
    const StudyTable& table = report.tables.front();
    const auto column = std::ranges::find(table.columns, "holds", &StudyColumn::name);
    if (column == table.columns.end()) return StudyVerdict::None;
    const auto place = static_cast<std::size_t>(column - table.columns.begin());
    const auto holding = std::ranges::count_if(
        table.rows, [&](const auto& row) { return row[place] == StudyValue(std::string("yes")); });
    if (holding == 0) return StudyVerdict::HoldsNot;
    return holding == std::ranges::ssize(table.rows) ? StudyVerdict::Holds : StudyVerdict::HoldsPartly;
}

} // namespace touchdown
