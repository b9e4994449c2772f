// SPDX-License-Identifier: GPL-3.0-or-later
//
// Misspelt or misplaced words of the command line, and the command that was probably meant.
#pragma once

#include <string>
#include <vector>

namespace touchdown {

struct CommandWords {
    std::vector<std::string> commands; // "run", "study"
    std::vector<std::string> kinds;    // after "study"
};

/// A sentence about a first word that is not a command, or a word after "study" that is not a kind, with a suggestion;
/// "" when both are known or missing.
std::string mistakenWord(const std::vector<std::string>& arguments, const CommandWords& known);

/// A sentence about the arguments that a command did not take; `options` are all of its options, with their dashes.
std::string notTaken(const std::string& command, const std::vector<std::string>& left,
                     const std::vector<std::string>& options);

} // namespace touchdown
