// SPDX-License-Identifier: GPL-3.0-or-later
//
// Case files: TOML, described by core/simulation/fields.h.
#pragma once

#include "core/simulation/case.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace touchdown {

/// One problem of an input, in one sentence: "fig10.toml:7: springs.cutof: unknown key; did you mean springs.cutoff?"
struct InputProblem {
    std::string file;
    int line = 0; // 0: the whole file
    std::string key;
    std::string message;

    std::string text() const;
};

/// A case as read; valid when `problems` is empty.
struct CaseDocument {
    Case value;
    std::string text;                   // the input as it stands, with its comments
    std::string name;                   // of the file or the sample case
    std::filesystem::path folder;       // of the files that the text names
    std::vector<InputProblem> problems; // all of them
    std::vector<InputProblem> warnings; // what the input says and is not modelled; the case is valid all the same
    std::vector<InputProblem> unused;   // what it gives without effect beside what else it says
    bool valid() const { return problems.empty(); }
};

/// Largest case file that is read [byte].
inline constexpr std::uintmax_t maximumCaseFileSize = 1 << 20;

/// Reads TOML text. `name` appears in the problems. Files that the text names (abs.rails) are looked for in `folder`;
/// without one they are a problem.
CaseDocument parseCase(std::string text, std::string name, const std::filesystem::path& folder = {});
/// Reads a file; a directory, an unreadable, empty, binary or oversized file is a problem by name.
CaseDocument readCaseFile(const std::filesystem::path& file);
/// A case file, or the name of a sample case.
CaseDocument openCase(const std::string& fileOrName);

/// "key=value" as given to --set, applied in order; problems are added to the document, as are the check of combinations and what
/// has no effect.
void applySettings(CaseDocument& document, const std::vector<std::string>& settings);

/// The whole case as TOML, every used field written, with a comment per group.
std::string formatCase(const Case& c);
/// `text` with the values of `c` put in place: comments, order and spelling of what has not changed are kept. A file of
/// rails stays named if the text will stand in `folder` and the rails are still those of the file there; else the rails
/// are written into the text.
std::string updateCaseText(const std::string& text, const Case& c, const std::filesystem::path& folder = {});
/// Writes through a temporary file and a rename, so that a failure leaves the old file as it was. Returns the problem, or "".
std::string writeCaseFile(const std::filesystem::path& file, const std::string& text);

/// The sample cases that are built into the program, in the paper's order.
struct SampleCase {
    std::string name;
    std::string text;
};
const std::vector<SampleCase>& sampleCases();
/// The case with which the program opens.
inline constexpr std::string_view defaultCaseName = "fig10a";

} // namespace touchdown
