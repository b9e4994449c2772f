// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings, charts and tables of a study of cycles.
#pragma once

#include "core/studies/cycles/cycles_result.h"
#include "core/studies/study/study.h"

namespace touchdown {

/// The end of a sentence that warns of W < 0.
inline constexpr const char* creatingLaw =
    ": each touch-down and take-off gives energy to the slider, as no real contact does.";

std::vector<std::string> cyclesFindings(const CyclesTask& task, const CyclesResult& result);
StudyReport cyclesReport(const CyclesTask& task, const CyclesResult& result);

} // namespace touchdown
