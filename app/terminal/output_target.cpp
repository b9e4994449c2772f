// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/output_target.h"

#include <filesystem>
#include <system_error>

#include <unistd.h>

#include "core/formats/output_file.h"

namespace touchdown {

namespace {

namespace fs = std::filesystem;

/// Whether two names mean the same file, which need not exist.
bool sameFile(const std::string& a, const std::string& b)
{
    std::error_code none;
    if (fs::equivalent(a, b, none)) return true;
    const fs::path path = fs::weakly_canonical(fs::absolute(a, none), none);
    return !path.empty() && path == fs::weakly_canonical(fs::absolute(b, none), none);
}

/// Why this file cannot be written; "" if it can.
std::string problemOf(const OutputTarget& target, const std::string& input)
{
    std::error_code none;
    const fs::file_status status = fs::status(target.file, none);
    const bool stream = target.mayBeStream && (fs::is_character_file(status) || fs::is_fifo(status));
    if (!stream || ::access(target.file.c_str(), W_OK) != 0)
        if (const std::string problem = checkOutputFile(target.file); !problem.empty()) return problem;
    return fs::exists(input, none) && sameFile(target.file, input) ? target.file + " is the case file itself" : "";
}

} // namespace

std::vector<InputProblem> targetProblems(const std::vector<OutputTarget>& targets, const std::string& input)
{
    std::vector<InputProblem> problems;
    for (auto one = targets.begin(); one != targets.end(); ++one) {
        if (one->file.empty()) continue;
        if (const std::string problem = problemOf(*one, input); !problem.empty())
            problems.push_back({"", 0, one->option, problem});
        for (auto other = targets.begin(); other != one; ++other)
            if (!other->file.empty() && sameFile(other->file, one->file))
                problems.push_back({"", 0, other->option + " and " + one->option, "both name " + one->file});
    }
    return problems;
}

} // namespace touchdown
