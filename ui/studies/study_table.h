// SPDX-License-Identifier: GPL-3.0-or-later
//
// A table of a study's report: heads with units, numbers in display units with as many digits as can be read.
#pragma once

#include "core/studies/study/study.h"
#include "ui/style/result_table.h"

namespace touchdown {

TableRow headsOf(const StudyTable& table);
std::vector<TableRow> rowsOf(const StudyTable& table);

} // namespace touchdown
