// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the headings and comments of a surface file say of its columns: their units, an index column, heights that count
// downwards, quantities that are no height.
//
// A heading counts if it falls into one cell for each column (core/formats/surfaces/heading_cells.h) and its names fit
// the columns (core/formats/surfaces/column_name.h). In a comment each word must be known. All other text is prose,
// which gives no unit to a column. Two lines of values, "lateral_unit: um" and "height_unit: nm", are as good.
#pragma once

#include <optional>
#include <vector>

#include "core/formats/surfaces/header_values.h"
#include "core/formats/surfaces/map_table.h"
#include "core/formats/surfaces/surface_units.h"

namespace touchdown {

/// What the text before the numbers says of the columns.
struct ColumnHeading {
    ColumnUnits units;
    std::optional<HeadingLine> turned; // the line that says that heights count downwards
    std::vector<HeadingLine> doubts;   // sentences on names that are not known, and how they were read
    std::vector<int> lines;            // that are headings
};
/// `columns` of heights alone, of x and height, or of x, y and height. The units must be those of the key where both
/// are given. Throws CmlError where there are none, fewer or more than columns, units that are no length, or where a
/// name is no place or no height. A name that is not known is refused, too, where the file gives the units; where the
/// case does, it is a doubt.
ColumnHeading columnHeading(const MapTable& table, const HeaderValues& values, const ColumnUnits& key);

/// Takes out a first column that counts the rows from 0 or 1 where a heading says so: "index", "#", "line", or nothing
/// as in ",x [um],h [nm]". Throws CmlError where no heading says so.
void takeOutIndex(MapTable& table);

/// Throws CmlError where a heading or comment between the rows begins a second channel or profile.
void refuseSecondChannel(const MapTable& table, bool matrix);

} // namespace touchdown
