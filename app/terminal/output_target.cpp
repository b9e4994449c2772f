// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/output_target.h"

#include <algorithm>
#include <exception>
#include <system_error>

#include <unistd.h>

namespace touchdown {

namespace {

namespace fs = std::filesystem;

/// Whether two names mean the same file, which need not exist.
bool sameFile(const std::string& a, const std::string& b)
{
    std::error_code none;
    if (fs::equivalent(a, b, none)) return true;
    const fs::path path = linkTarget(fs::absolute(a, none));
    return !path.empty() && path == linkTarget(fs::absolute(b, none));
}

/// Why this file cannot be written; "" if it can.
std::string problemOf(const OutputTarget& target, const std::vector<fs::path>& inputs)
{
    std::error_code none;
    const fs::file_status status = fs::status(target.file, none);
    const bool stream = target.mayBeStream && (fs::is_character_file(status) || fs::is_fifo(status));
    if (!stream || ::access(target.file.c_str(), W_OK) != 0)
        if (const std::string problem = checkOutputFile(target.file); !problem.empty()) return problem;
    // By device and inode, so that a link to an input counts.
    const auto isTarget = [&](const fs::path& input) { return fs::equivalent(input, target.file, none); };
    return std::ranges::any_of(inputs, isTarget) ? target.file + " is read by this command; name another file" : "";
}

} // namespace

std::vector<InputProblem> targetProblems(const std::vector<OutputTarget>& targets, const std::vector<fs::path>& inputs)
{
    std::vector<InputProblem> problems;
    for (auto one = targets.begin(); one != targets.end(); ++one) {
        if (one->file.empty()) continue;
        if (const std::string problem = problemOf(*one, inputs); !problem.empty())
            problems.push_back({"", 0, one->option, problem});
        for (auto other = targets.begin(); other != one; ++other)
            if (!other->file.empty() && sameFile(other->file, one->file))
                problems.push_back({"", 0, other->option + " and " + one->option, "both name " + one->file});
    }
    return problems;
}

TargetLocks::TargetLocks(const std::vector<OutputTarget>& targets)
{
    for (const OutputTarget& target : targets) {
        if (target.file.empty()) continue;
        try {
            locks_.push_back(std::make_unique<OutputLock>(linkTarget(target.file)));
        } catch (const std::exception& failure) {
            problems_.push_back({"", 0, target.option, "cannot write to " + target.file + ": " + failure.what()});
        }
    }
}

} // namespace touchdown
