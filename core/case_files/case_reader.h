// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a TOML text becomes a case: each value where its field puts it, each problem with its line. For the files that
// read cases; see core/case_files/case_file.h.
#pragma once

#include "core/case/fields.h"
#include "core/case_files/case_file.h"
#include "core/formats/toml_document.h"

#include <optional>
#include <string>
#include <string_view>

namespace touchdown {

/// Sets a field from a value of a case file; returns what is wrong with it, in a sentence without the key.
std::optional<std::string> setFromToml(Case& target, const Field& field, const TomlValue& value);

/// A key that is short enough for a message.
std::string shortenedKey(std::string_view key);

} // namespace touchdown
