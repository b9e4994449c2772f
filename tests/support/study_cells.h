// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells of the tables of a study's report, by name. The table and the column must be there.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <variant>

#include "core/studies/study/study.h"

namespace touchdown::test {

inline const StudyTable& table(const StudyReport& report, const std::string& name)
{
    return *std::ranges::find(report.tables, name, &StudyTable::name);
}

inline std::size_t columnOf(const StudyTable& t, const std::string& name)
{
    return std::size_t(std::ranges::find(t.columns, name, &StudyColumn::name) - t.columns.begin());
}

inline double number(const StudyTable& t, std::size_t row, const std::string& column)
{
    return std::get<double>(t.rows[row][columnOf(t, column)]);
}

inline std::string word(const StudyTable& t, std::size_t row, const std::string& column)
{
    return std::get<std::string>(t.rows[row][columnOf(t, column)]);
}

} // namespace touchdown::test
