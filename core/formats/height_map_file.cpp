// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/height_map_file.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <variant>

#include "core/formats/cml_text.h"
#include "core/formats/height_map_builder.h"
#include "core/formats/height_map_hdf5.h"
#include "core/formats/quotation.h"
#include "core/formats/text_file.h"
#include "core/formats/words.h"
#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largestFile = 1u << 30; // [byte]
constexpr std::string_view columnSeparators = " \t,;\v\f";

std::string endingOf(const std::string& name) { return lowerCase(fs::path(name).extension().string()); }

bool isComment(std::string_view line)
{
    return line.starts_with('#') || line.starts_with('%') || line.starts_with('!') || line.starts_with("//");
}

/// "nan", "-inf", "NA" and other marks for a missing measurement.
bool standsForHole(std::string_view word)
{
    const std::string lower = lowerCase(word.starts_with('-') || word.starts_with('+') ? word.substr(1) : word);
    return lower.starts_with("nan") || lower.starts_with("inf") || lower == "na" || lower == "bad" || lower == "-" ||
           lower == "--" || lower == "*" || lower == "null" || lower.starts_with("1.#");
}

/// Lines with equal counts of numbers, and the text around them.
struct Table {
    std::size_t columns = 0;
    std::vector<double> numbers;
    std::vector<int> lines;       // of the file, one for each row
    std::vector<double> shortRow; // a last line with other than `columns` numbers
    int shortLine = 0;
    std::vector<std::string> words; // comments and headings

    std::size_t rows() const { return lines.size(); }
    double at(std::size_t row, std::size_t column) const { return numbers[row * columns + column]; }
};

void readRow(std::string_view line, int number, std::vector<double>& row)
{
    row.clear();
    for (std::size_t at = line.find_first_not_of(columnSeparators); at != std::string_view::npos;
         at = line.find_first_not_of(columnSeparators, at)) {
        const std::string_view word = line.substr(at, line.find_first_of(columnSeparators, at) - at);
        const auto value = readCmlNumber(word);
        if (!value && standsForHole(word))
            throw CmlError(number, "a map has no holes: every height must be a number, not " + inQuotes(word));
        if (!value) throw CmlError(number, "a line of numbers is needed, not " + inQuotes(word));
        row.push_back(*value);
        at += word.size();
    }
}

void refuseShortRow(const Table& table)
{
    if (table.shortLine == 0) return;
    throw CmlError(table.shortLine, "has " + counted(table.shortRow.size(), "number") + ", the lines before it " +
                                        std::to_string(table.columns) +
                                        "; a map has no holes: every line must be complete");
}

Table readTable(std::string_view text)
{
    Table table;
    std::vector<double> row;
    for (CmlText reader(text); !reader.atEnd();) {
        const int number = reader.line();
        const std::string_view line = trimmed(reader.takeLine(), blanks);
        if (line.empty()) continue;
        const std::string_view word = line.substr(0, line.find_first_of(columnSeparators));
        const bool heading = table.rows() == 0 && !readCmlNumber(word) && !standsForHole(word);
        if (isComment(line) || heading) {
            table.words.emplace_back(line);
            continue;
        }
        refuseShortRow(table);
        readRow(line, number, row);
        if (row.empty()) continue;
        if (table.rows() == 0) table.columns = row.size();
        if (row.size() != table.columns) {
            table.shortRow = row;
            table.shortLine = number;
            continue;
        }
        table.numbers.insert(table.numbers.end(), row.begin(), row.end());
        table.lines.push_back(number);
        if (table.numbers.size() > 3 * static_cast<std::size_t>(mostMapPoints))
            throw CmlError(number, "there are too many points; at most 64 million can be read");
    }
    if (table.rows() == 0)
        throw CmlError(0,
                       "holds no numbers; a profile has two columns, x and height, and a map three, x, y and height");
    return table;
}

/// The factors of the units that a heading gives in brackets, one for each column; 1 without them.
std::vector<double> columnUnits(const Table& table)
{
    for (const std::string& words : table.words) {
        std::vector<double> factors;
        for (std::size_t open = words.find_first_of("[("); open != std::string::npos;
             open = words.find_first_of("[(", open + 1)) {
            const std::size_t close = words.find_first_of("])", open);
            if (close == std::string::npos) break;
            if (const auto factor = lengthUnit(words.substr(open + 1, close - open - 1))) factors.push_back(*factor);
        }
        if (factors.size() == table.columns) return factors;
    }
    return std::vector<double>(table.columns, 1.0);
}

MapAxis axisOf(const Table& table, std::size_t column, double unit, std::size_t count, std::size_t stride,
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

HeightMap profileOf(const Table& table)
{
    const auto units = columnUnits(table);
    const MapAxis x = axisOf(table, 0, units[0], table.rows(), 1, "x");
    std::vector<double> heights(table.rows());
    for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = table.at(i, 1) * units[1];
    return builtMap(x, {1, 0.0, x.step}, std::move(heights));
}

std::string pointText(bool turned, double quick, double late)
{
    return "x = " + inMetres(turned ? late : quick) + ", y = " + inMetres(turned ? quick : late);
}

/// Points in lines along x or, `turned`, along y.
HeightMap mapOfPoints(const Table& table)
{
    const auto units = columnUnits(table);
    const std::size_t rows = table.rows();
    const bool turned = rows > 1 && table.at(1, 0) == table.at(0, 0);
    const std::size_t fast = turned ? 1 : 0, slow = turned ? 0 : 1;
    std::size_t length = 1; // of a line of points
    while (length < rows && table.at(length, slow) == table.at(0, slow)) ++length;
    const MapAxis quick = axisOf(table, fast, units[fast], length, 1, turned ? "y" : "x");
    const MapAxis late = axisOf(table, slow, units[slow], (rows + length - 1) / length, length, turned ? "x" : "y");
    for (std::size_t k = 0; k < rows; ++k) {
        const double a = table.at(k, fast) * units[fast], b = table.at(k, slow) * units[slow];
        if (!quick.holds(k % length, a) || !late.holds(k / length, b))
            throw CmlError(table.lines[k], "a map has no holes: the point " +
                                               pointText(turned, quick.at(k % length), late.at(k / length)) +
                                               " is needed here; points must come line by line, along x or along y");
    }
    if (rows % length != 0)
        throw CmlError(table.lines.back(), "a map has no holes: its last line ends after " +
                                               std::to_string(rows % length) + " of " + std::to_string(length) +
                                               " points");
    std::vector<double> heights(rows);
    for (std::size_t k = 0; k < rows; ++k) {
        const std::size_t at = turned ? (k % length) * (rows / length) + k / length : k;
        heights[at] = table.at(k, 2) * units[2];
    }
    return turned ? builtMap(late, quick, std::move(heights)) : builtMap(quick, late, std::move(heights));
}

/// Lines "x h1 ... hny" and one of y.
HeightMap mapOfWaveDefinition(const Table& table)
{
    if (table.columns < 2)
        throw CmlError(table.lines.front(), "a line of x [m] and one or more heights [nm] is needed");
    const std::size_t ny = table.columns - 1;
    if (table.shortLine == 0)
        throw CmlError(table.lines.back(),
                       "the last line must hold only the y [m] of each profile, " + counted(ny, "number"));
    if (table.shortRow.size() != ny)
        throw CmlError(table.shortLine, "the last line must hold the y [m] of each profile, " + counted(ny, "number") +
                                            ", not " + std::to_string(table.shortRow.size()));
    const MapAxis x = axisOf(table, 0, 1.0, table.rows(), 1, "x");
    MapAxis y{1, 0.0, x.step};
    if (ny > 1) y = equalSteps(table.shortRow, std::vector<int>(ny, table.shortLine), "y");
    std::vector<double> heights;
    heights.reserve(table.rows() * ny);
    for (std::size_t j = 0; j < ny; ++j)
        for (std::size_t i = 0; i < table.rows(); ++i) heights.push_back(table.at(i, j + 1) * 1e-9);
    return builtMap(x, y, std::move(heights));
}

/// The value of "# Width: 10 um" or "# width = 10 um".
std::optional<std::string> wordsOf(const Table& table, std::string_view key)
{
    for (const std::string& words : table.words) {
        const std::string lower = lowerCase(words);
        const auto begin = lower.find_first_not_of("#%!/ \t");
        if (begin == std::string::npos || !std::string_view(lower).substr(begin).starts_with(key)) continue;
        const auto value = lower.find_first_not_of(" \t", begin + key.size());
        if (value == std::string::npos || (lower[value] != ':' && lower[value] != '=')) continue;
        return std::string(trimmed(std::string_view(words).substr(value + 1), blanks));
    }
    return std::nullopt;
}

HeightMap mapOfMatrix(const Table& table, const std::string& width, const std::string& height)
{
    const auto side = [](const std::string& text, const char* name) {
        const auto value = lengthOf(text);
        if (value && *value > 0.0) return *value;
        throw CmlError(0, std::string(name) + " must be a length above 0 with its unit, as \"10 um\", not " +
                              inQuotes(text));
    };
    const std::string unit = wordsOf(table, "value units").value_or("m");
    const auto factor = lengthUnit(unit);
    if (!factor) throw CmlError(0, "Value units must be a unit of length, as \"nm\", not " + inQuotes(unit));
    const auto columns = static_cast<double>(table.columns), rows = static_cast<double>(table.rows());
    std::vector<double> heights(table.numbers);
    for (double& h : heights) h *= *factor;
    return builtMap({table.columns, 0.0, side(width, "Width") / columns},
                    {table.rows(), 0.0, side(height, "Height") / rows}, std::move(heights));
}

HeightMap mapOf(const Table& table, const std::string& name)
{
    if (endingOf(name) == ".def") return mapOfWaveDefinition(table);
    refuseShortRow(table);
    const auto width = wordsOf(table, "width"), height = wordsOf(table, "height");
    if (width && height) return mapOfMatrix(table, *width, *height);
    if (table.columns == 2) return profileOf(table);
    if (table.columns == 3) return mapOfPoints(table);
    throw CmlError(
        table.lines.front(),
        "has " + counted(table.columns, "number") +
            "; a profile has two columns, x and height, a map three, x, y and height, and a matrix of heights "
            "needs the comments \"# Width: 10 um\" and \"# Height: 5 um\" before it");
}

} // namespace

HeightMapDocument readHeightMapText(std::string_view text, const std::string& name)
{
    HeightMapDocument document;
    try {
        document.map = mapOf(readTable(text), name);
    } catch (const CmlError& error) {
        document.problems.push_back({name, error.line(), "", error.what()});
    }
    return document;
}

HeightMapDocument readHeightMap(const fs::path& file, const std::string& name)
{
    const std::string ending = endingOf(file.string());
    HeightMapDocument document;
    if (ending == ".h5" || ending == ".hdf5") {
        try {
            document.map = readHeightMapHdf5(file);
        } catch (const CmlError& error) {
            document.problems.push_back({name, 0, "", error.what()});
        }
        return document;
    }
    std::error_code error;
    if (const auto size = fs::file_size(file, error);
        !error && fs::is_regular_file(file, error) && size > largestFile) {
        document.problems.push_back({name, 0, "", "is larger than 1 GiB; a surface is read from at most that"});
        return document;
    }
    const auto text = readTextFile(file, largestFile);
    if (const auto* problem = std::get_if<FileProblem>(&text)) {
        document.problems.push_back({name, 0, "", problem->message});
        return document;
    }
    return readHeightMapText(std::get<std::string>(text), name);
}

} // namespace touchdown
