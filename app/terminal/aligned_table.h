// SPDX-License-Identifier: GPL-3.0-or-later
//
// A table for people.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace touchdown {

/// Characters, not bytes: "µ" is as wide as "u".
std::size_t textWidth(const std::string& text);

/// Columns as wide as their widest entry; those named in `left` begin where their heading begins, the others end with
/// it. Each row ends with a line break.
std::string alignedTable(const std::vector<std::vector<std::string>>& rows, const std::vector<bool>& left = {});

} // namespace touchdown
