// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks of the files that a command will write, before it begins.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/formats/input_problem.h"
#include "core/formats/output_file.h"

namespace touchdown {

/// A file that a command may write, by the option that names it; "" for none.
struct OutputTarget {
    std::string option;
    std::string file;
    bool mayBeStream = false; // a device or a pipe, too
};

/// A problem, with the option as its key, for every file that cannot be written, is one of the `inputs`, by whatever
/// name, or is named twice.
std::vector<InputProblem> targetProblems(const std::vector<OutputTarget>& targets,
                                         const std::vector<std::filesystem::path>& inputs);

/// Keeps the files that a command writes at its end (core/formats/output_file.h).
class TargetLocks {
public:
    explicit TargetLocks(const std::vector<OutputTarget>& targets);

    /// Targets that another run writes to.
    const std::vector<InputProblem>& problems() const { return problems_; }
    /// Just before the files are written: their writers lock them.
    void release() { locks_.clear(); }

private:
    std::vector<std::unique_ptr<OutputLock>> locks_;
    std::vector<InputProblem> problems_;
};

} // namespace touchdown
