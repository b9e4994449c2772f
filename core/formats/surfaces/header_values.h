// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values with a name before the numbers of a surface file, as Gwyddion, SPIP, WSxM, Keyence, ESRI and people write
// them:
//
//   # Width: 10 um     x-length = 10000     "XY Calibration (nm/pixel)","277.5"     ncols 64     lateral_unit: um
//
// A matrix of heights needs its size or the distance of its points, heights alone need that distance.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/surfaces/map_table.h"
#include "core/formats/surfaces/surface_units.h"

namespace touchdown {

enum class HeaderField : std::uint8_t {
    SizeX,       // "Width": of the whole map
    SizeY,       // "Height"
    StepX,       // between points
    StepY,       //
    Step,        // in both directions
    PointsX,     // in a line
    PointsY,     // lines
    LateralUnit, // of x, and of y without a unit of its own
    UnitY,       // in a profile that of its heights
    HeightUnit,  //
    HeightRange, // with the unit of the heights, as WSxM writes it
    Bit2nm,      // SPIP: a step of the heights in nm; lengths without unit are in nm
    Scale,       // a factor of the heights
    Missing,     // the number of a missing point
    Channel,     //
    Count
};

struct HeaderValue {
    std::string value{};
    std::string unit{}; // in brackets beside the name
    int line = 0;
    std::string other{}; // a second value that differs, and its line
    int otherLine = 0;
};

class HeaderValues {
public:
    explicit HeaderValues(const MapTable& table) : HeaderValues(table.headings) {}
    explicit HeaderValues(const std::vector<HeadingLine>& lines);

    bool has(HeaderField field) const { return values_[static_cast<std::size_t>(field)].has_value(); }
    /// Throws CmlError where the value is given twice and differs.
    const std::optional<HeaderValue>& of(HeaderField field) const;
    /// The first value of each field, whatever else is given.
    std::vector<std::pair<HeaderField, HeaderValue>> given() const;
    /// Whether a matrix has its size.
    bool sizesMatrix() const;

private:
    std::array<std::optional<HeaderValue>, static_cast<std::size_t>(HeaderField::Count)> values_;
};

/// The distances of the points of a matrix, or of heights alone, whose units are those of x and y by the key [m].
struct PointSteps {
    double x = 0.0, y = 0.0; // y: 0 for a single line
};
PointSteps pointSteps(const MapTable& table, const HeaderValues& values, const ColumnUnits& key);
/// The units that the values give [m].
std::optional<double> lateralUnit(const HeaderValues& values);
std::optional<double> unitOfY(const HeaderValues& values);
std::optional<double> heightUnit(const HeaderValues& values);

/// Throws CmlError where the channel is no height, where heights have a factor, or where the number of a missing point
/// stands in a column from `first` on. Returns whether the channel counts downwards.
bool channelIsTurned(const MapTable& table, const HeaderValues& values, std::size_t first);

/// Whether a line gives the size, the unit or the name of a channel.
bool beginsChannel(std::string_view line);

[[noreturn]] void refuseOtherThanKey(int line);

/// The parts of a line that are none of these values.
std::vector<std::string_view> remarksIn(std::string_view line);

/// "name: 16", "name = 16", "x unit: um": a value with its name, no heading of columns.
bool isValue(std::string_view line);

} // namespace touchdown
