// SPDX-License-Identifier: GPL-3.0-or-later
//
// Case files and sample cases: opened by name, read, written.
#pragma once

#include "core/case/case_document.h"
#include "core/case_files/outside_path.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

/// The sample cases that are built into the program, in the paper's order.
struct SampleCase {
    std::string name;
    std::string text;
};
const std::vector<SampleCase>& sampleCases();
/// The title of a sample case, as parseCase reads it. That takes milliseconds for a film: a list needs no
/// more than titles.
std::string titleOf(const SampleCase& sample);
/// Films to begin a design with: typical sliders with simple surfaces. "pico_two_rails"
const std::vector<SampleCase>& sliderTemplates();
/// The case with which the program opens.
inline constexpr std::string_view defaultCaseName = "fig10a";

/// A case file (TOML), files of the established program, or a sample case by its name. A name that is none of them is
/// a problem of the kind NotFound.
CaseDocument openCase(const std::string& fileOrName, OutsidePaths outside = OutsidePaths::Refused);

/// Reads a TOML file; a directory, an unreadable, empty, binary or oversized file is a problem that names the file.
CaseDocument readCaseFile(const std::filesystem::path& file, OutsidePaths outside = OutsidePaths::Refused);

/// Writes through a temporary file and a rename, so that a failure leaves the old file unchanged. Returns the problem,
/// or "".
std::string writeCaseFile(const std::filesystem::path& file, const std::string& text);

} // namespace touchdown
