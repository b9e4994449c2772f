// SPDX-License-Identifier: GPL-3.0-or-later
//
// Remarks of a surface file that were not used and that may concern its numbers. A remark is all text before, between
// and behind the numbers that is neither a heading of columns nor a value that was read.
//
// A remark is doubtful if one of its clauses, by the words of core/formats/surfaces/column_name.h,
//
//   speaks of depths or of a function       "pits are positive", "standard deviation over 64 tracks", "multiply by 10"
//   speaks of heights, data, an axis, ...   "Height", "values", "column 2", "z"
//     and of a direction or a sign          "z points into the disk"
//     or of a factor or another quantity    "z sensitivity: 10 nm/V", "type: gap"
//     or of a unit that is not the columns' "heights are in pm", "data in V", "heights in waves"
//   counts other points than the file has   "32 x 16 points"
//   gives another unit, distance of points or range of heights than the file
//
// A figure of the surface, "pit depth: 3 nm", "rms roughness 1.2 nm", is no doubt, and neither are a date, an
// instrument or other conditions of the measurement.
#pragma once

#include <vector>

#include "core/formats/surfaces/header_values.h"
#include "core/formats/surfaces/map_table.h"
#include "core/formats/surfaces/surface_units.h"

namespace touchdown {

/// The doubtful remarks with their lines, at most ten. `units` are those of the columns [m], that of the heights last;
/// `used` are the lines that were read as headings of columns. `matrix`: each row is a line of heights.
std::vector<HeadingLine> unusedRemarks(const MapTable& table, const HeaderValues& values, const ColumnUnits& units,
                                       const std::vector<int>& used, bool matrix);

} // namespace touchdown
