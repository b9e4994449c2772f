// SPDX-License-Identifier: GPL-3.0-or-later
//
// TOML text to case: core/case/parameters.h describes the keys; every problem carries its line.
#pragma once

#include "core/case/case_document.h"
#include "core/case/parameters.h"
#include "core/case_files/outside_path.h"
#include "core/formats/toml_document.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace touchdown {

/// Whether the file of a measured surface is read, to find its problems.
enum class MeasuredSurface { Checked, Unread };

/// Reads TOML text. `name` appears in the problems. Files that the text names (abs.rails) are looked up in `folder`;
/// without a folder they are a problem, and so are files outside it unless they are allowed. Reading the file of a
/// measured surface takes about 1 s for each million points; it changes no value.
CaseDocument parseCase(std::string text, std::string name, const std::filesystem::path& folder = {},
                       OutsidePaths outside = OutsidePaths::Refused,
                       MeasuredSurface surface = MeasuredSurface::Checked);

/// Sets a parameter from a value of a case file; returns what is wrong with it, in a sentence without the key.
std::optional<std::string> setFromToml(Case& target, const Parameter& parameter, const TomlValue& value);

/// A key that is short enough for a message.
std::string shortenedKey(std::string_view key);

} // namespace touchdown
