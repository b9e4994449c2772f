// SPDX-License-Identifier: GPL-3.0-or-later
//
// A study that is a list, solved in parts by other processes of this program: jobs of Slurm, or what any other launcher
// starts. All stands in one folder, so that the same command takes up what is under way:
//
//   study.h5      the study with its case, as it was when the folder was made
//   part.sh       solves one part; an administrator may change it
//   part_3.h5     of part 3, with part_3.h5.items while it is under way
//   log/3.txt     what that part wrote to its terminal
//   jobs.txt      of Slurm: the numbers of the jobs
//   result.h5     of all parts together
//
// A part that ended before it was done, by a lost node or a limit of time, is submitted again; items that are solved
// are not solved again, since each part goes on in its file. Nothing waits on a network: the files tell what is done.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "core/studies/study/study.h"

namespace touchdown {

struct StudyPlan;

enum class EngineKind : std::uint8_t {
    Local,  // one part after the other, on this computer
    Slurm,  // a job array (sbatch, squeue)
    Command // a command of the shell that starts a program for each part and ends when all have ended
};

struct EngineTask {
    EngineKind kind = EngineKind::Slurm;
    std::filesystem::path folder, program; // where all stands; the program `touchdown`
    std::size_t parts = 1;
    int jobs = 1;        // threads of each part
    std::string options; // of sbatch, as a shell takes them
    /// Of Command: "parallel -j8". {script} and {parts} in it are replaced by the script and the numbers of the parts;
    /// without them " {script} ::: {parts}" is added, as GNU parallel takes it.
    std::string submit;
    int tries = 5; // of a part that makes no progress
};

/// Why this computer has no such engine, in a sentence; "" where it has.
std::string reasonAgainst(EngineKind kind);

/// The plan is a list. Submits what is not done, follows it and joins all parts. Where the callback returns false, jobs
/// of Slurm go on, and the report says how to take them up. `tell` receives what a person should know meanwhile.
StudyReport performByEngine(const StudyPlan& plan, const EngineTask& task, const StudyCallback& callback,
                            const std::function<void(const std::string&)>& tell);

} // namespace touchdown
