// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown validate` and `touchdown list`; what all commands on cases have in common.
#pragma once

#include "app/command_line.h"
#include "core/simulation/case_file.h"

namespace touchdown {

/// Tells standard error what a case says that is not modelled, and each of its problems.
void complainOf(const CaseDocument& document);

/// The case that the arguments name, with its settings; all of that, and what has no effect, has gone to standard error.
CaseDocument openCaseOrComplain(const CaseArguments& arguments);

/// The same of a case that must have an air film.
CaseDocument openFilmCaseOrComplain(const CaseArguments& arguments);

int validateCommand(const CaseArguments& arguments, bool json);
int listCommand(bool json);

} // namespace touchdown
