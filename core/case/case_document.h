// SPDX-License-Identifier: GPL-3.0-or-later
//
// A case as it was read: its values, its text, and every problem that was found.
#pragma once

#include "core/case/case.h"
#include "core/formats/input_problem.h"

#include <filesystem>
#include <string>
#include <vector>

namespace touchdown {

/// A case as read; valid when `problems` is empty.
struct CaseDocument {
    Case value;
    std::string text;                   // the input as it stands, with its comments
    std::string name;                   // of the file or the sample case
    std::filesystem::path folder;       // of the files that the text names
    std::vector<InputProblem> problems; // all of them
    std::vector<InputProblem> warnings; // what the input says and is not modelled; the case is valid all the same
    std::vector<InputProblem> unused;   // what it gives without effect beside what else it says
    bool valid() const { return problems.empty(); }
};

} // namespace touchdown
