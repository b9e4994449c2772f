// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/output_target.h"

#include <filesystem>
#include <system_error>

#include "app/terminal/console.h"
#include "core/formats/output_file.h"

namespace touchdown {

namespace fs = std::filesystem;

bool sameFile(const std::string& a, const std::string& b)
{
    std::error_code none;
    if (fs::equivalent(a, b, none)) return true;
    const fs::path path = fs::weakly_canonical(fs::absolute(a, none), none);
    return !path.empty() && path == fs::weakly_canonical(fs::absolute(b, none), none);
}

bool targetIsGood(const std::string& option, const std::string& file, const std::string& problem,
                  const std::string& caseName)
{
    if (file.empty()) return true;
    std::error_code none;
    if (!problem.empty())
        complain(option + ": " + problem);
    else if (fs::exists(caseName, none) && sameFile(file, caseName))
        complain(option + ": " + file + " is the case file itself");
    else
        return true;
    return false;
}

bool targetsAreGood(const std::vector<OutputTarget>& targets, const std::string& input)
{
    bool good = true;
    for (auto one = targets.begin(); one != targets.end(); ++one) {
        if (one->file.empty()) continue;
        good = targetIsGood(one->option, one->file, checkOutputFile(one->file), input) && good;
        for (auto other = targets.begin(); other != one; ++other) {
            if (other->file.empty() || !sameFile(other->file, one->file)) continue;
            complain(other->option + " and " + one->option + ": both name " + one->file);
            good = false;
        }
    }
    return good;
}

} // namespace touchdown
