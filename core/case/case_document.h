// SPDX-License-Identifier: GPL-3.0-or-later
//
// A case as read: its values, its text and all its problems.
#pragma once

#include "core/case/case.h"
#include "core/formats/input_problem.h"

#include <filesystem>
#include <string>
#include <vector>

namespace touchdown {

/// Valid if `problems` is empty.
struct CaseDocument {
    Case value;
    std::string text;             // the input, with its comments
    std::string name;             // of the file or the sample case
    std::filesystem::path folder; // of the files that the text names
    std::vector<InputProblem> problems;
    std::vector<std::string> outsideFiles; // named by the text, but outside its folder; each is one of the problems
    std::vector<InputProblem> warnings;    // parts of the input that are not modelled
    std::vector<InputProblem> unused;      // values without effect
    bool valid() const { return problems.empty(); }
};

} // namespace touchdown
