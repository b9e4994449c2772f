// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks of the files that a command will write, before it begins.
#pragma once

#include <string>
#include <vector>

#include "core/formats/input_problem.h"

namespace touchdown {

/// A file that a command may write, by the option that names it; "" for none.
struct OutputTarget {
    std::string option;
    std::string file;
    bool mayBeStream = false; // a device or a pipe, too
};

/// A problem, with the option as its key, for every file that cannot be written, is the input, or is named twice.
std::vector<InputProblem> targetProblems(const std::vector<OutputTarget>& targets, const std::string& input);

} // namespace touchdown
