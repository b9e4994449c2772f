// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown list`; what all commands on cases have in common.
#pragma once

#include "app/terminal/console.h"
#include "core/case_files/case_file.h"

namespace touchdown {

/// Tells standard error what a case says that is not modelled, and each of its problems.
void complainOf(const CaseDocument& document);

/// The case of a name, with settings; all that is wrong has gone to standard error.
CaseDocument openCaseToKeep(const std::string& name, const std::vector<std::string>& settings = {});

/// The same, and what has no effect has gone there, too.
CaseDocument openCaseOrComplain(const CaseArguments& arguments);

/// The same of a case that must have an air film.
CaseDocument openFilmCaseOrComplain(const CaseArguments& arguments);

int listCommand(bool json);

} // namespace touchdown
