// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks of the files that a command will write, before it begins.
#pragma once

#include <string>
#include <vector>

namespace touchdown {

/// Whether two names lead to one file, which need not exist.
bool sameFile(const std::string& a, const std::string& b);

/// Complains about a file with the given problem, or that is the case itself. "" is no file.
bool targetIsGood(const std::string& option, const std::string& file, const std::string& problem,
                  const std::string& caseName);

/// A file that a command may write, by the option that names it; "" for none.
struct OutputTarget {
    std::string option;
    std::string file;
};

/// Complains about every file that cannot be written as a regular file, is the input, or is named twice.
bool targetsAreGood(const std::vector<OutputTarget>& targets, const std::string& input);

} // namespace touchdown
