// SPDX-License-Identifier: GPL-3.0-or-later
//
// A problem of an input file, a setting or an option.
#pragma once

#include <cstdint>
#include <string>

namespace touchdown {

enum class ProblemKind : std::uint8_t {
    Input,        // a text, a key or a value that cannot be read
    Combination,  // values that contradict each other
    MeasuredDisk, // the file of a measured disk surface
    NotFound,     // neither a file nor a sample case has this name
    Setting,      // a value set by --set or by a study
};

/// Its text() is one printable sentence, whatever the file held: "fig10.toml:7: springs.cutof: unknown key; did you
/// mean springs.cutoff?"
struct InputProblem {
    std::string file;
    int line = 0; // 0: the whole file
    std::string key;
    std::string message;
    ProblemKind kind = ProblemKind::Input;

    std::string text() const;
};

} // namespace touchdown
