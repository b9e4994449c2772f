// SPDX-License-Identifier: GPL-3.0-or-later
//
// A heading of columns: one cell for each, with a name, a unit, or both.
//
//   x [um]  h (nm)        x in um, h in nm      x_um;h_nm     x/um  h/nm     x: um, h: nm     x um, h nm
//   um, nm                x, h [um, nm]         columns: x (um), h (nm)
//
// The separator of the numbers divides a line into cells where the line has it, else another one, else its words. A
// line that does not fall into one cell for each column is no heading: its words and units say nothing of the columns.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

/// A longer line is neither a heading nor a value [byte].
inline constexpr std::size_t longestHeading = 4096;

struct HeadingCell {
    std::string name;             // "track position"; empty beside a unit alone
    std::string unit;             // as it is written; empty: none
    std::optional<double> metres; // of the unit; empty: no unit, or not clearly one of length
};
using HeadingCells = std::vector<HeadingCell>;

/// `separator` is that of the numbers, a blank for blanks and tabs. Nothing where the line is no heading.
std::optional<HeadingCells> headingCells(std::string_view line, char separator, std::size_t columns);

/// The line without the mark of a comment.
std::string_view withoutMark(std::string_view line);

} // namespace touchdown
