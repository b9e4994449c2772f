// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown validate` and `touchdown list`.
#pragma once

#include "app/command_line.h"
#include "core/simulation/case_file.h"

namespace touchdown {

/// The case that the arguments name, with its settings; each of its problems has gone to standard error.
CaseDocument openCaseOrComplain(const CaseArguments& arguments);

int validateCommand(const CaseArguments& arguments, bool json);
int listCommand(bool json);

} // namespace touchdown
