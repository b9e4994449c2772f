// SPDX-License-Identifier: GPL-3.0-or-later
//
// One problem of an input file, a setting or an option, as one sentence.
#pragma once

#include <string>

namespace touchdown {

/// One problem of an input, in one sentence: "fig10.toml:7: springs.cutof: unknown key; did you mean springs.cutoff?"
struct InputProblem {
    std::string file;
    int line = 0; // 0: the whole file
    std::string key;
    std::string message;

    std::string text() const;
};

} // namespace touchdown
