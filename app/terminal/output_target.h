// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that a command writes, looked at before it begins.
#pragma once

#include <string>
#include <vector>

namespace touchdown {

/// Whether two names lead to one file, which need not exist.
bool sameFile(const std::string& a, const std::string& b);

/// Complains of a file that cannot be written, for the given reason or because it is the case itself. "" is no file.
bool targetIsGood(const std::string& option, const std::string& file, const std::string& problem,
                  const std::string& caseName);

/// A file that a command may write, by the option that names it; "" for none.
struct OutputTarget {
    std::string option;
    std::string file;
};

/// Complains of all that cannot be written as a regular file, and of those that name one file or the input.
bool targetsAreGood(const std::vector<OutputTarget>& targets, const std::string& input);

} // namespace touchdown
