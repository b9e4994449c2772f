// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output_target.h"

#include <filesystem>
#include <system_error>

#include "app/command_line.h"

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

} // namespace touchdown
