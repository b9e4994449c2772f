// SPDX-License-Identifier: GPL-3.0-or-later
//
// Case files: TOML, described by core/case/fields.h.
#pragma once

#include "core/case/case_document.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

/// Largest case file that is read [byte].
inline constexpr std::uintmax_t maximumCaseFileSize = 1 << 20;

/// Reads TOML text. `name` appears in the problems. Files that the text names (abs.rails) are looked for in `folder`;
/// without one they are a problem.
CaseDocument parseCase(std::string text, std::string name, const std::filesystem::path& folder = {});
/// Reads a file; a directory, an unreadable, empty, binary or oversized file is a problem by name.
CaseDocument readCaseFile(const std::filesystem::path& file);
/// A case file, or the name of a sample case.
CaseDocument openCase(const std::string& fileOrName);

/// "key=value" as given to --set, applied in order; problems are added to the document, as are the check of
/// combinations and what has no effect.
void applySettings(CaseDocument& document, const std::vector<std::string>& settings);

/// The whole case as TOML, every used field written, with a comment per group.
std::string formatCase(const Case& c);
/// `text` with the values of `c` put in place: comments, order and spelling of what has not changed are kept. A file of
/// rails stays named if the text will stand in `folder` and the rails are still those of the file there; else the rails
/// are written into the text.
std::string updateCaseText(const std::string& text, const Case& c, const std::filesystem::path& folder = {});
/// Writes through a temporary file and a rename, so that a failure leaves the old file as it was. Returns the problem,
/// or "".
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
