// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arguments that are no command, because they are misspelt or in another order; suggests the likely command.
#pragma once

#include <string>
#include <vector>

namespace touchdown {

struct CommandWords {
    std::vector<std::string> commands; // "run", "study"
    std::vector<std::string> kinds;    // behind "study"
};

/// A sentence about a first word that is no command, or about a word behind "study" that is no kind, with the likely
/// meaning. "" when both are known or missing.
std::string mistakenWord(const std::vector<std::string>& arguments, const CommandWords& known);

/// A sentence about the arguments that a command did not take; `options` are all of its options, with their dashes.
std::string notTaken(const std::string& command, const std::vector<std::string>& left,
                     const std::vector<std::string>& options);

} // namespace touchdown
