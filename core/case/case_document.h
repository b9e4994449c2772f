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
    std::string text;                         // the input, with its comments
    std::string name;                         // of the file or the sample case
    std::filesystem::path folder;             // of the files that the text names
    std::vector<std::filesystem::path> files; // that were read, without the file of a measured surface
    std::vector<InputProblem> problems;
    std::vector<std::string> outsideFiles; // named by the text, but outside its folder; each is one of the problems
    std::vector<InputProblem> warnings;    // parts of the input that are not modelled
    std::vector<InputProblem> unused;      // values without effect
    bool valid() const { return problems.empty(); }
    /// All files of the case, none of a sample case: what the program writes must not take their place.
    std::vector<std::filesystem::path> inputs() const
    {
        std::vector<std::filesystem::path> all = files;
        if (!value.diskSurface.file.empty()) all.push_back(value.folder / value.diskSurface.file);
        return all;
    }
};

} // namespace touchdown
