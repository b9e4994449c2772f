// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown list`, `touchdown validate` and `touchdown convert`; how commands open a
// case. Warnings of a case go to standard error; its problems are left to the command.
#pragma once

#include <string>

#include "app/commands/command_arguments.h"

namespace touchdown {

struct CaseDocument;

/// The case with its settings. Keys without effect are not reported.
CaseDocument openCaseToKeep(const CommandArguments& arguments);
/// The same; keys without effect are reported.
CaseDocument openCaseToUse(const CommandArguments& arguments);
/// The same for a case that must have an air film.
CaseDocument openFilmCase(const CommandArguments& arguments);

int listCommand(bool json);
/// Every problem of a case, or of a study and its case.
int validateCommand(const CommandArguments& arguments);
/// Between case files and the files of the established slider program (CML), both ways: the name is that of any case;
/// `to` is a case file if it ends with .toml, an archive if it ends with .cml, a drawing of the surface if it ends with
/// .dxf, else a folder.
/// Files of the established program that stand there are replaced only with `force`; a file that is read never is.
int convertCommand(const CommandArguments& arguments, const std::string& to, bool force);

} // namespace touchdown
