// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown list`, `touchdown validate` and `touchdown convert`; the arguments of the commands, and how they open a
// case. Warnings of a case go to standard error; its problems are left to the command.
#pragma once

#include <string>
#include <vector>

#include "core/case_files/outside_path.h"

namespace touchdown {

struct CaseDocument;

/// Each command has some of them.
struct CommandArguments {
    std::string name;                  // a case file or a sample case; for studies also a study
    std::vector<std::string> settings; // KEY=VALUE, of the case
    std::string kind;                  // of study, one of studyKinds()
    std::vector<std::string> options;  // KEY=VALUE, of the study
    std::string out;                   // HDF5; "" for none
    std::string csv;                   // "" for none
    std::string apply;                 // the case that the study found; "" for none
    std::string part;                  // "K/N" of a list study; "" for all of it
    std::vector<std::string> join;     // files of parts
    bool resume = false;               // a list study goes on in its file
    std::string engine;                // of a list study: "local", "slurm", "command"; "" for this process
    int parts = 0;                     // of the engine; 0: not given
    std::string sbatch, submit;        // options of sbatch; the command of the launcher
    int jobs = 0;                      // 0: as many as there are cores
    bool fixedAttitude = false;
    bool asTemplate = false; // print a study of the case instead
    bool progress = false;
    bool allowPaths = false; // files outside the folders of case and study
    bool json = false;

    OutsidePaths outside() const { return allowPaths ? OutsidePaths::Allowed : OutsidePaths::Refused; }
};

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
