// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings, charts and tables of a study of cycles.
#pragma once

#include "core/studies/cycles/cycles_result.h"
#include "core/studies/study/study.h"

namespace touchdown {

std::vector<std::string> cyclesFindings(const CyclesTask& task, const CyclesResult& result);
StudyReport cyclesReport(const CyclesTask& task, const CyclesResult& result);

} // namespace touchdown
