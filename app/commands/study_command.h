// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown study KIND` and `touchdown advise`: many solutions of one case and their evaluation.
#pragma once

#include <string>
#include <vector>

namespace touchdown {

struct CommandArguments;
struct StudyPlan;

std::vector<std::string> studyKindNames();

/// Writes the warnings of a study and its case to standard error.
void warnOf(const StudyPlan& plan);

int studyCommand(const CommandArguments& arguments);

} // namespace touchdown
