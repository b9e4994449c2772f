// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/height_map_file.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>
#include <variant>

#include "core/formats/cml_text.h"
#include "core/formats/quotation.h"
#include "core/formats/reader_process.h"
#include "core/formats/surfaces/height_map_builder.h"
#include "core/formats/surfaces/height_map_hdf5.h"
#include "core/formats/surfaces/map_holes.h"
#include "core/formats/surfaces/map_table.h"
#include "core/formats/surfaces/surface_heading.h"
#include "core/formats/text_encoding.h"
#include "core/formats/text_file.h"
#include "core/formats/words.h"

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
    return equalSteps(places, lines, name);
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

HeightMap profileOf(MapTable table, const ColumnUnits& key)
{
    const auto units = columnUnits(table, key);
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
HeightMap mapOfPoints(const MapTable& unsorted, const ColumnUnits& key)
{
    const auto units = columnUnits(unsorted, key);
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
            throw CmlError(table.lines[k], "a map has no holes: the point x = " + inMetres(x.at(k % length)) +
                                               ", y = " + inMetres(y.at(k / length)) + " is missing before this one");
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

HeightMap mapOfMatrix(const MapTable& table, const MatrixHeading& heading, const ColumnUnits& key)
{
    const MatrixSize size = matrixSize(table, heading, key);
    refuseMarks(table, 0);
    std::vector<double> heights(table.numbers);
    for (double& h : heights) h *= size.valueUnit;
    return builtMap({table.columns, 0.0, size.width / static_cast<double>(table.columns)},
                    {table.rows(), 0.0, size.height / static_cast<double>(table.rows())}, std::move(heights));
}

HeightMap mapOf(MapTable table, const std::string& name, const ColumnUnits& key)
{
    if (endingOf(name) == ".def") return mapOfWaveDefinition(table, key);
    const MatrixHeading heading = matrixHeading(table);
    const bool matrix = heading.width && heading.height && table.columns > 3;
    refuseSecondChannel(table, matrix);
    refuseShortRow(table);
    if (matrix) return mapOfMatrix(table, heading, key);
    takeOutIndex(table);
    if (table.columns == 2) return profileOf(std::move(table), key);
    if (table.columns == 3) return mapOfPoints(table, key);
    throw CmlError(
        table.lines.front(),
        "has " + counted(table.columns, "number") +
            "; a profile has two columns, x and height, a map three, x, y and height, and a matrix of heights "
            "needs the comments \"# Width: 10 um\" and \"# Height: 5 um\" before it");
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
                         const std::function<HeightMap(const ColumnUnits&)>& read)
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
        document.map = read(*key);
    } catch (const CmlError& error) {
        document.problems.push_back({name, error.line(), "", error.what()});
    }
    return document;
}

} // namespace

HeightMapDocument readHeightMapText(std::string text, const std::string& name, const std::string& unit)
{
    return readBy(name, unit, [&](const ColumnUnits& key) {
        const std::string utf8 = asUtf8(std::move(text));
        return mapOf(readMapTable(utf8), name, key);
    });
}

HeightMapDocument readHeightMap(const fs::path& file, const std::string& name, const std::string& unit)
{
    const std::string ending = endingOf(file.string());
    if (ending == ".h5" || ending == ".hdf5")
        return readBy(name, unit, [&](const ColumnUnits&) { return mapByReader(file, unit); });
    HeightMapDocument document;
    auto text = readTextFile(file, largestFile, FileContent::Text);
    if (const auto* problem = std::get_if<FileProblem>(&text)) {
        document.problems.push_back({name, 0, "", problem->message});
        return document;
    }
    return readHeightMapText(std::move(std::get<std::string>(text)), name, unit);
}

} // namespace touchdown
