// SPDX-License-Identifier: GPL-3.0-or-later
//
// run.dat and dynamics.def: sections. A section is a line that begins with a star and holds the section's name, then
// lists of numbers, each below a heading line. A heading is any text that does not begin with a number; only the order
// of the lists counts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/formats/cml_text.h"

namespace touchdown {

/// The numbers below one heading, up to the next word that is not a number.
struct CmlList {
    std::string_view heading{};
    int line = 0; // of the heading
    std::vector<CmlNumber> numbers;
    std::string_view after{}; // the word that follows the numbers; empty at the end of the section
    int afterLine = 0;
};

struct CmlSection {
    std::string name; // "Load Parameters"
    int line = 0;
    std::vector<CmlList> lists;
    std::string_view body{}; // all text up to the next section
};

struct CmlSections {
    std::vector<CmlSection> sections;
    int lastLine = 0; // that is not blank
};

/// `text` outlives the result. A section named comments takes the rest of the file. Throws CmlError.
CmlSections splitCmlSections(std::string_view text);

} // namespace touchdown
