// SPDX-License-Identifier: GPL-3.0-or-later
//
// Case to TOML text: a new text, or new values in a text that a person wrote.
#pragma once

#include "core/case/case.h"

#include <filesystem>
#include <string>

namespace touchdown {

/// The whole case as TOML: every used parameter, with a comment per group.
std::string formatCase(const Case& c);

/// `text` with the values of `c`: comments, order and spelling of all unchanged values are kept. A file of rails stays
/// named if the text will stand in `folder` and the rails are still those of the file there; else the rails are written
/// into the text.
std::string updateCaseText(const std::string& text, const Case& c, const std::filesystem::path& folder = {});

} // namespace touchdown
