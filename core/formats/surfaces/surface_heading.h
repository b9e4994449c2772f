// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the headings and comments of a surface file say: units of its columns, an index column, size and unit of a
// matrix.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/surfaces/map_table.h"

namespace touchdown {

/// Units of length of the columns [m]; empty where none are given.
using ColumnUnits = std::vector<double>;

/// The value of disk.surface.unit: "um, nm". Nothing if it holds another word.
std::optional<ColumnUnits> unitsOfKey(std::string_view text);
/// One unit for each of `columns`: one for all, one for each, or one for x and y and one for heights.
ColumnUnits unitsOfKey(const ColumnUnits& key, std::size_t columns);

/// The units that the headings name, which must be those of the key where both are given. Throws CmlError where there
/// are none, fewer or more than columns, or units that are no length.
ColumnUnits columnUnits(const MapTable& table, const ColumnUnits& key);

/// Takes out a first column that counts the rows from 0 or 1 where a heading says so: "index", "#", "no", or nothing as
/// in ",x [um],h [nm]". Throws CmlError where no heading says so.
void takeOutIndex(MapTable& table);

/// "# Width: 10 um", "width [um] = 10".
struct HeadingValue {
    std::string value;
    std::string unit; // in brackets beside the name
    int line = 0;
};
struct MatrixHeading {
    std::optional<HeadingValue> width, height, valueUnits;
};
/// Throws CmlError where a value is given twice and differs.
MatrixHeading matrixHeading(const MapTable& table);

/// The sides and the unit of the heights of a matrix [m].
struct MatrixSize {
    double width = 0.0, height = 0.0, valueUnit = 0.0;
};
MatrixSize matrixSize(const MapTable& table, const MatrixHeading& heading, const ColumnUnits& key);

/// Throws CmlError where a heading or comment between the rows begins a second channel or profile.
void refuseSecondChannel(const MapTable& table, bool matrix);

} // namespace touchdown
