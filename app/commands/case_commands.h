// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown list`; how all commands open a case.
#pragma once

#include "app/terminal/console.h"
#include "core/case_files/case_file.h"

namespace touchdown {

/// Writes the warnings and problems of a case to standard error.
void complainOf(const CaseDocument& document);

/// The case of a name, with settings; warnings and problems have been written to standard error.
CaseDocument openCaseToKeep(const std::string& name, const std::vector<std::string>& settings = {});

/// The same, and keys without effect have been reported, too.
CaseDocument openCaseOrComplain(const CaseArguments& arguments);

/// The same for a case that must have an air film.
CaseDocument openFilmCaseOrComplain(const CaseArguments& arguments);

int listCommand(bool json);

} // namespace touchdown
