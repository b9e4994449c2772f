// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arguments of the commands.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/case_files/outside_path.h"

namespace touchdown {

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
    /// Of a run, between its states [s]; none: 1.
    std::optional<double> checkpointEach{};
    std::string resumeRun;      // a run goes on: "true", "anyway"; "" for no
    std::string engine;         // of a list study: "local", "slurm", "command"; "" for this process
    int parts = 0;              // of the engine; 0: not given
    std::string sbatch, submit; // options of sbatch; the command of the launcher
    int jobs = 0;               // 0: as many as there are cores
    bool fixedAttitude = false;
    bool asTemplate = false; // print a study of the case instead
    bool progress = false;
    bool allowPaths = false; // files outside the folders of case and study
    bool json = false;

    OutsidePaths outside() const { return allowPaths ? OutsidePaths::Allowed : OutsidePaths::Refused; }
};

} // namespace touchdown
