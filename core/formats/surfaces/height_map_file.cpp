// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/height_map_file.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>
#include <variant>

#include "core/formats/cml_text.h"
#include "core/formats/quotation.h"
#include "core/formats/reader_process.h"
#include "core/formats/surfaces/header_values.h"
#include "core/formats/surfaces/height_map_builder.h"
#include "core/formats/surfaces/height_map_hdf5.h"
#include "core/formats/surfaces/map_holes.h"
#include "core/formats/surfaces/map_table.h"
#include "core/formats/surfaces/surface_fields.h"
#include "core/formats/surfaces/surface_heading.h"
#include "core/formats/surfaces/surface_remarks.h"
#include "core/formats/text_encoding.h"
#include "core/formats/text_file.h"
#include "core/formats/words.h"
#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largestFile = 1u << 30; // [byte]

std::string endingOf(const std::string& name) { return lowerCase(fs::path(name).extension().string()); }

/// The numbers of columns from `first` to the last, which are heights as the file writes them.
void refuseMarks(const MapTable& table, std::size_t first)
{
    std::vector<double> heights;
    heights.reserve(table.rows() * (table.columns - first));
    for (std::size_t row = 0; row < table.rows(); ++row)
        for (std::size_t column = first; column < table.columns; ++column) heights.push_back(table.at(row, column));
    if (const auto hole = findHole(heights))
        throw CmlError(table.lines[*hole / (table.columns - first)], holeText(heights[*hole]));
}

MapAxis axisOf(const MapTable& table, std::size_t column, double unit, std::size_t count, std::size_t stride,
               const char* name)
{
    std::vector<double> places;
    std::vector<int> lines;
    places.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        places.push_back(table.at(k * stride, column) * unit);
        lines.push_back(table.lines[k * stride]);
    }
    return equalSteps(places, lines, name, unit);
}

/// With its rows in another order.
MapTable reordered(const MapTable& table, const std::vector<std::size_t>& order)
{
    MapTable sorted = table;
    for (std::size_t row = 0; row < order.size(); ++row) {
        sorted.lines[row] = table.lines[order[row]];
        for (std::size_t column = 0; column < table.columns; ++column)
            sorted.numbers[row * table.columns + column] = table.at(order[row], column);
    }
    return sorted;
}

HeightMap profileOf(MapTable table, const ColumnUnits& units)
{
    for (std::size_t row = 2; row < table.rows(); ++row)
        if (table.at(row, 0) == table.at(0, 0))
            throw CmlError(table.lines[row],
                           "x returns to its start: a second profile begins here; one profile is read "
                           "from a file");
    refuseMarks(table, 1);
    if (table.at(table.rows() - 1, 0) < table.at(0, 0)) {
        std::vector<std::size_t> order(table.rows());
        std::iota(order.rbegin(), order.rend(), std::size_t{0});
        table = reordered(table, order);
    }
    const MapAxis x = axisOf(table, 0, units[0], table.rows(), 1, "x");
    std::vector<double> heights(table.rows());
    for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = table.at(i, 1) * units[1];
    return builtMap(x, {1, 0.0, x.step}, std::move(heights));
}

/// Line by line along x, from the lowest y.
MapTable inOrder(const MapTable& table)
{
    const auto before = [&](std::size_t a, std::size_t b) {
        return std::pair(table.at(a, 1), table.at(a, 0)) < std::pair(table.at(b, 1), table.at(b, 0));
    };
    std::vector<std::size_t> order(table.rows());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (std::ranges::is_sorted(order, before)) return table;
    std::ranges::stable_sort(order, before);
    return reordered(table, order);
}

/// Points in any order.
HeightMap mapOfPoints(const MapTable& unsorted, const ColumnUnits& units)
{
    refuseMarks(unsorted, 2);
    std::size_t ascending = 1;
    while (ascending < unsorted.rows() && unsorted.at(ascending, 0) > unsorted.at(ascending - 1, 0)) ++ascending;
    if (ascending > 1 && ascending == unsorted.rows())
        throw CmlError(unsorted.lines.front(),
                       "has three columns, which are x, y and height of a map, but each x once; a "
                       "profile has two columns, x and height");
    const MapTable table = inOrder(unsorted);
    const std::size_t rows = table.rows();
    for (std::size_t k = 1; k < rows; ++k)
        if (table.at(k, 0) == table.at(k - 1, 0) && table.at(k, 1) == table.at(k - 1, 1))
            throw CmlError(table.lines[k], "a point is here a second time, after line " +
                                               std::to_string(table.lines[k - 1]) +
                                               "; one channel is read from a file");
    std::size_t length = 1; // of a line of points
    while (length < rows && table.at(length, 1) == table.at(0, 1)) ++length;
    const MapAxis x = axisOf(table, 0, units[0], length, 1, "x");
    const MapAxis y = axisOf(table, 1, units[1], (rows + length - 1) / length, length, "y");
    for (std::size_t k = 0; k < rows; ++k)
        if (!x.holds(k % length, table.at(k, 0) * units[0]) || !y.holds(k / length, table.at(k, 1) * units[1]))
            throw CmlError(table.lines[k], "a map has no holes: the point x = " + inUnit(x.at(k % length), units[0]) +
                                               ", y = " + inUnit(y.at(k / length), units[1]) +
                                               " is missing before this one");
    if (rows % length != 0)
        throw CmlError(table.lines.back(), "a map has no holes: its last line ends after " +
                                               std::to_string(rows % length) + " of " + std::to_string(length) +
                                               " points");
    std::vector<double> heights(rows);
    for (std::size_t k = 0; k < rows; ++k) heights[k] = table.at(k, 2) * units[2];
    return builtMap(x, y, std::move(heights));
}

/// Lines "x h1 ... hny" and one of y.
HeightMap mapOfWaveDefinition(const MapTable& table, const ColumnUnits& key)
{
    if (table.columns < 2)
        throw CmlError(table.lines.front(), "a line of x [m] and one or more heights [nm] is needed");
    const ColumnUnits units = unitsOfKey(key, 2);
    if (!units.empty() && (units[0] != 1.0 || units[1] != 1e-9))
        throw CmlError(0, "is in m and nm, as every wave.def, and disk.surface.unit gives other units");
    const std::size_t ny = table.columns - 1;
    if (table.shortLine == 0)
        throw CmlError(table.lines.back(),
                       "the last line must hold only the y [m] of each profile, " + counted(ny, "number"));
    if (table.shortRow.size() != ny)
        throw CmlError(table.shortLine, "the last line must hold the y [m] of each profile, " + counted(ny, "number") +
                                            ", not " + std::to_string(table.shortRow.size()));
    refuseMarks(table, 1);
    const MapAxis x = axisOf(table, 0, 1.0, table.rows(), 1, "x");
    MapAxis y{1, 0.0, x.step};
    if (ny > 1) y = equalSteps(table.shortRow, std::vector<int>(ny, table.shortLine), "y");
    std::vector<double> heights;
    heights.reserve(table.rows() * ny);
    for (std::size_t j = 0; j < ny; ++j)
        for (std::size_t i = 0; i < table.rows(); ++i) heights.push_back(table.at(i, j + 1) * 1e-9);
    return builtMap(x, y, std::move(heights));
}

/// Throws where the first row or column of a matrix holds places: it ascends in equal steps, and no other does.
void refusePlaces(const MapTable& table)
{
    const auto equal = [&](std::size_t count, const auto& at) {
        if (count < 4) return false;
        const double step = at(1) - at(0);
        bool same = step != 0.0;
        for (std::size_t i = 2; same && i < count; ++i)
            same = std::abs(at(i) - at(0) - static_cast<double>(i) * step) <= 1e-3 * std::abs(step);
        return same;
    };
    const auto column = [&](std::size_t j) {
        return equal(table.rows(), [&, j](std::size_t i) { return table.at(i, j); });
    };
    const auto row = [&](std::size_t i) {
        return equal(table.columns, [&, i](std::size_t j) { return table.at(i, j); });
    };
    const auto alone = [](const auto& isEqual, std::size_t count) {
        std::size_t next = 1;
        while (next < count && !isEqual(next)) ++next;
        return count > 1 && isEqual(0) && next == count;
    };
    if (alone(column, table.columns) || alone(row, table.rows()))
        throw CmlError(table.lines.front(),
                       "the first row or column ascends in equal steps: it holds places or counts, no heights");
}

/// Rows of heights, or one height in each line.
HeightMap mapOfHeights(const MapTable& table, const PointSteps& steps, double unit)
{
    refuseMarks(table, 0);
    std::vector<double> heights(table.numbers);
    for (double& h : heights) h *= unit;
    if (table.columns == 1) return builtMap({table.rows(), 0.0, steps.x}, {1, 0.0, steps.x}, std::move(heights));
    return builtMap({table.columns, 0.0, steps.x}, {table.rows(), 0.0, steps.y}, std::move(heights));
}

/// The unit of the heights of a matrix, by the file or by the case.
double matrixUnit(const MapTable& table, const HeaderValues& values, const ColumnUnits& key)
{
    const auto unit = heightUnit(values);
    const double byKey = key.empty() ? 0.0 : key.back();
    if (!unit && byKey <= 0.0)
        throw CmlError(table.lines.front(),
                       "the heights have no unit; \"# Value units: nm\" gives it, or the case "
                       "gives all, as disk.surface.unit = \"um, nm\" for the sides and the heights");
    if (unit && byKey > 0.0 && std::abs(*unit - byKey) > 1e-9 * byKey)
        refuseOtherThanKey(values.has(HeaderField::HeightUnit) ? values.of(HeaderField::HeightUnit)->line : 0);
    return unit ? *unit : byKey;
}

/// "which are x and height ..." of a table that is none of them.
[[noreturn]] void refuseColumns(const MapTable& table)
{
    throw CmlError(table.lines.front(),
                   "has " + counted(table.columns, "number") +
                       "; a profile has two columns, x and height, a map three, x, y and height, and a matrix of "
                       "heights needs the comments \"# Width: 10 um\" and \"# Height: 5 um\" before it; heights alone "
                       "need \"# Spacing: 0.5 um\"");
}

void turn(HeightMap& map, const HeadingLine& line, const std::string& name, std::vector<InputProblem>& warnings)
{
    for (double& h : map.heights) h = -h;
    warnings.push_back({name, line.line, "", "counts heights downwards; the surface was turned: high values are pits"});
}

HeightMap mapOf(MapTable table, const std::string& name, const ColumnUnits& key, std::vector<InputProblem>& warnings)
{
    if (endingOf(name) == ".def") return mapOfWaveDefinition(table, key);
    const HeaderValues values(table);
    const bool matrix = values.sizesMatrix() && table.columns > 3;
    const bool alone = table.columns == 1 && (values.has(HeaderField::StepX) || values.has(HeaderField::Step));
    refuseSecondChannel(table, matrix);
    refuseShortRow(table);
    if (!matrix) takeOutIndex(table);
    if (!matrix && !alone && table.columns != 2 && table.columns != 3) refuseColumns(table);
    const bool turnedChannel = channelIsTurned(table, values, matrix ? 0 : table.columns - 1);
    std::optional<HeadingLine> turned;
    if (turnedChannel) turned = HeadingLine{{}, values.of(HeaderField::Channel)->line, true};
    HeightMap map;
    std::vector<HeadingLine> doubts, remarks;
    if (matrix) {
        const ColumnUnits units = unitsOfKey(key, 3);
        refusePlaces(table);
        const PointSteps steps = pointSteps(table, values, units);
        const double unit = matrixUnit(table, values, units);
        remarks = unusedRemarks(table, values, {unit}, {}, true);
        map = mapOfHeights(table, steps, unit);
    } else {
        const ColumnUnits units = unitsOfKey(key, alone ? 2 : table.columns);
        const ColumnUnits ofHeights = alone && !units.empty() ? ColumnUnits{units.back()} : units;
        const ColumnHeading heading = columnHeading(table, values, ofHeights);
        if (heading.turned) turned = heading.turned;
        doubts = heading.doubts;
        remarks = unusedRemarks(table, values, heading.units, heading.lines, false);
        map = alone                ? mapOfHeights(table, pointSteps(table, values, units), heading.units[0])
              : table.columns == 2 ? profileOf(std::move(table), heading.units)
                                   : mapOfPoints(table, heading.units);
    }
    if (turned) turn(map, *turned, name, warnings);
    for (const HeadingLine& each : doubts) warnings.push_back({name, each.line, "", each.text});
    for (const HeadingLine& each : remarks)
        warnings.push_back({name, each.line, "", "has a remark that was not used: " + inQuotes(each.text)});
    return map;
}

bool isMap(const HeightMap& map)
{
    const auto finite = [](double v) { return std::isfinite(v); };
    return map.nx > 0 && map.ny > 0 && finite(map.dx) && map.dx > 0.0 && finite(map.dy) &&
           map.heights.size() == static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(map.ny) &&
           std::ranges::all_of(map.heights, finite);
}

/// By a process of its own, which reads it with readHeightMapHdf5.
HeightMap mapByReader(const fs::path& file, const std::string& unit)
{
    std::string problem = notRegularFile(file);
    if (!problem.empty()) throw CmlError(0, problem);
    HeightMap map;
    try {
        readAnswer({"surface", file, unit}, problem, map);
    } catch (const ReaderFailure& failure) {
        throw CmlError(0, failure.what());
    }
    if (!problem.empty()) throw CmlError(0, problem);
    if (!isMap(map)) throw CmlError(0, "is damaged: what was read from it is no map");
    return map;
}

HeightMapDocument readBy(const std::string& name, const std::string& unit,
                         const std::function<HeightMap(const ColumnUnits&, std::vector<InputProblem>&)>& read)
{
    HeightMapDocument document;
    const auto key = unitsOfKey(unit);
    if (!key) {
        document.problems.push_back(
            {name, 0, "disk.surface.unit",
             "must hold units of length, one for each column or one for all, as \"um, nm\", not " + inQuotes(unit)});
        return document;
    }
    try {
        document.map = read(*key, document.warnings);
        for (const DiskSurfaceProblem& each : heightMapProblems(document.map))
            document.problems.push_back({name, 0, "", each.sentence});
    } catch (const CmlError& error) {
        document.problems.push_back({name, error.line(), "", error.what()});
    }
    return document;
}

} // namespace

HeightMapDocument readHeightMapText(std::string text, const std::string& name, const std::string& unit)
{
    return readBy(name, unit, [&](const ColumnUnits& key, std::vector<InputProblem>& warnings) {
        if (isSimpleField(text)) return mapOf(readSimpleField(text), name, key, warnings);
        const std::string utf8 = asUtf8(std::move(text));
        return mapOf(isSdf(utf8) ? readSdf(utf8) : readMapTable(utf8), name, key, warnings);
    });
}

HeightMapDocument readHeightMap(const fs::path& file, const std::string& name, const std::string& unit)
{
    const std::string ending = endingOf(file.string());
    if (ending == ".h5" || ending == ".hdf5")
        return readBy(name, unit, [&](const auto&...) { return mapByReader(file, unit); });
    HeightMapDocument document;
    auto text = readTextFile(file, largestFile, ending == ".gsf" ? FileContent::Any : FileContent::Text);
    if (const auto* problem = std::get_if<FileProblem>(&text)) {
        document.problems.push_back({name, 0, "", problem->message});
        return document;
    }
    return readHeightMapText(std::move(std::get<std::string>(text)), name, unit);
}

} // namespace touchdown
