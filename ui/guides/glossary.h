// SPDX-License-Identifier: GPL-3.0-or-later
//
// The terms of the program with their explanations, for the lesson, the demonstrations and the help. They are data, in
// resources/help/glossary.toml:
//
//   [[entry]]
//   term = "take-off height"
//   also = ["take-off heights", "d_e"]   # other spellings; may be left out
//   unit = "nm"                          # as in a case file; left out for a quantity without unit, and for a thing
//   text = "..."
//
// A word may begin with a capital letter in a text; a symbol is always written as it is here.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <QString>

#include "core/formats/input_problem.h"

namespace touchdown {

struct GlossaryEntry {
    std::string term;
    std::vector<std::string> also;
    std::string unit; // as in a case file; "" for none
    std::string text;
};

struct Glossary {
    std::vector<GlossaryEntry> entries; // those that can be read; all of them if there are no problems
    std::vector<InputProblem> problems;
};

/// "W", "mu", "f_c0".
bool isSymbol(std::string_view spelling);

/// `name` is that of the file, for the problems.
Glossary readGlossary(std::string_view text, const std::string& name);

/// That of the program.
const std::vector<GlossaryEntry>& glossaryEntries();

/// Term, symbols, unit and explanation as HTML, for a tool tip.
QString glossaryHtmlTip(const GlossaryEntry& entry);
/// The page of the help: a table of all terms in alphabetical order.
QString glossaryPage(const std::vector<GlossaryEntry>& entries);

} // namespace touchdown
