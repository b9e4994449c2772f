// SPDX-License-Identifier: GPL-3.0-or-later
//
// What was meant by arguments that are no command: words in another order, or misspelt.
#pragma once

#include <string>
#include <vector>

namespace touchdown {

struct CommandWords {
    std::vector<std::string> commands; // "run", "study"
    std::vector<std::string> kinds;    // behind "study"
};

/// A sentence about a first word that is no command, or about a word behind "study" that is no kind, with what was
/// meant if that is likely. "" when both are as they must be, or missing.
std::string mistakenWord(const std::vector<std::string>& arguments, const CommandWords& known);

/// A sentence about what a command did not take; `options` are all that it has, with their dashes.
std::string notTaken(const std::string& command, const std::vector<std::string>& left,
                     const std::vector<std::string>& options);

} // namespace touchdown
