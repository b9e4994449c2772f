// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of a kind of study: what its reader asks for, with the defaults and comments of its template. So there is no
// second list of them. A template offers a key that it does not set as "# key = value # comment".
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace touchdown {

struct StudyKey {
    std::string key;               // "repeats", "ensemble.starts"; "method.name" of each of [[method]]
    std::string allowed;           // "a whole number from 1 to 1000"
    std::string unit, displayUnit; // of a number; empty where there is none
    std::vector<std::pair<std::string, std::string>>
        standards;       // the default of each model that has one: {"springs", "5"}
    std::string help;    // "" where the templates say nothing
    bool inList = false; // of a list of tables
    bool varies = false; // what is allowed depends on the case; `allowed` is of the default case
};

/// In the order in which they are asked for; none for an unknown kind.
std::vector<StudyKey> studyKeys(const std::string& kind);

} // namespace touchdown
