// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a study found: as JSON for scripts; as sentences and tables for people.
#pragma once

#include <cstddef>
#include <string>

#include "core/studies/study/study.h"

namespace touchdown {

/// One object; numbers in SI, null where one is not known. It holds the charts, too.
std::string studyJson(const StudyReport& report);
/// Findings, warnings, tables of at most `width` characters.
std::string studyText(const StudyReport& report, std::size_t width);

} // namespace touchdown
