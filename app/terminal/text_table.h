// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tables for people. Each row ends with a line break.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace touchdown {

/// Columns as wide as their widest entry, aligned at the left where `left` is true, else at the right.
std::string alignedTable(const std::vector<std::vector<std::string>>& rows, const std::vector<bool>& left = {});

struct FittedColumn {
    std::string heading;    // may break behind '_' and at spaces
    bool text = false;      // aligned at the left, may be cut; numbers are aligned at the right
    bool secondary = false; // left out first
};

/// A table that fits into a width: headings of several lines, cut texts and, where that is not enough, fewer columns.
struct FittedTable {
    std::string text;
    std::vector<std::string> leftOut; // headings
    bool cut = false;                 // some text ends with an ellipsis
};
FittedTable fittedTable(const std::vector<FittedColumn>& columns, const std::vector<std::vector<std::string>>& rows,
                        std::size_t width);

/// Width of standard output: COLUMNS, else the terminal's width, else 100.
std::size_t outputWidth();

} // namespace touchdown
