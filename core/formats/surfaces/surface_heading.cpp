// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/surface_heading.h"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <string>
#include <utility>

#include "core/formats/cml_text.h"
#include "core/formats/quotation.h"
#include "core/formats/surfaces/column_name.h"
#include "core/formats/surfaces/heading_cells.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

constexpr const char* asKey =
    "each column needs a unit of length, as \"x [um]  h [nm]\" in a heading, or the case gives them all, as "
    "disk.surface.unit = \"um, nm\"";

constexpr std::string_view indexNames[] = {"index", "idx",   "no",     "nr", "n",          "i",    "id",
                                           "#",     "num",   "row",    "pt", "point",      "line", "number",
                                           "",      "zeile", "sample", "nr", "unnamed: 0", "pos.", "count"};

bool same(const ColumnUnits& a, const ColumnUnits& b)
{
    return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) <= 1e-9 * std::abs(y); });
}

/// Whether the first cell of a heading is the name of an index, or empty.
bool namesIndex(const HeadingLine& heading)
{
    const std::string_view text = withoutMark(heading.text);
    const std::string_view cell = text.substr(0, text.find_first_of(",;\t"));
    const auto named = [](std::string_view name) {
        name = trimmed(name.substr(0, name.find_first_of("[(")), " \t\"'.");
        return std::ranges::find(indexNames, lowerCase(name)) != std::end(indexNames);
    };
    if (cell.size() < text.size()) return named(cell);
    const std::string_view word = trimmed(text).substr(0, trimmed(text).find(' '));
    return !word.empty() && named(word);
}

/// A line with one cell for each column.
struct Heading {
    const HeadingLine* line = nullptr;
    HeadingCells cells;
    std::vector<ColumnName> names;
    bool divided = false; // by separators, not by its words alone

    bool hasUnits() const
    {
        return std::ranges::any_of(cells, [](const HeadingCell& each) { return !each.unit.empty(); });
    }
    bool complete() const
    {
        return std::ranges::all_of(cells, [](const HeadingCell& each) { return each.metres.has_value(); });
    }
    bool unitsAlone() const
    {
        return std::ranges::all_of(cells, [](const HeadingCell& each) { return each.name.empty(); });
    }
    bool known() const
    {
        return std::ranges::all_of(names, [](const ColumnName& each) { return each.known; });
    }
    bool holdsNone() const
    {
        return std::ranges::any_of(names, [](const ColumnName& each) { return each.role == ColumnRole::None; });
    }
    /// Whether a name may stand above column i.
    bool fits(std::size_t i) const
    {
        const bool first = i == 0 && cells.size() > 1, last = i + 1 == cells.size();
        switch (names[i].role) {
        case ColumnRole::X: return first;
        case ColumnRole::Y: return i == 1 || (first && cells.size() == 2);
        case ColumnRole::Height: return last;
        case ColumnRole::Any: return true;
        default: return false;
        }
    }
    bool fits() const
    {
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (!fits(i)) return false;
        return true;
    }
    /// "Height profile" and other titles, which fall into as many words as there are columns. A line right above the
    /// numbers is none where it is divided as they are, or where it begins with a place, "x recess".
    bool isTitle(bool nearest) const
    {
        if (nearest && (divided || (names.front().role == ColumnRole::X && names.front().known))) return false;
        const auto role = [&](ColumnRole r) { return std::ranges::count(names, r, &ColumnName::role); };
        const auto roles = role(ColumnRole::X) + role(ColumnRole::Y) + role(ColumnRole::Height);
        const bool named = nearest || names.front().role != ColumnRole::Unknown; // not "Tencor P-16+"
        const bool none = named && names.back().role == ColumnRole::None;
        return !hasUnits() && !fits() && !none && roles < (holdsNone() ? 1 : 2);
    }
    ColumnUnits units() const
    {
        ColumnUnits all;
        for (const HeadingCell& cell : cells) all.push_back(cell.metres.value_or(0.0));
        return all;
    }
};

/// Whether a line begins with a cell that is above no column: "Units<tab>um<tab>nm".
bool hasLabel(std::string_view line)
{
    const std::string lower = lowerCase(withoutMark(line));
    const std::string_view cell = std::string_view(lower).substr(0, lower.find_first_of("\t,;"));
    return cell == "units" || cell == "unit" || cell == "long name" || cell == "name";
}

std::optional<Heading> headingOf(const HeadingLine& line, const MapTable& table)
{
    if (isValue(line.text)) return std::nullopt;
    auto cells = headingCells(line.text, table.separator, table.columns + 1);
    if (cells && (table.indexed || hasLabel(line.text)))
        cells->erase(cells->begin());
    else
        cells = headingCells(line.text, table.separator, table.columns);
    if (!cells) return std::nullopt;
    const auto isNumber = [](const HeadingCell& each) { // "Scan length","60um", not "2*z"
        const auto number = each.unit.empty() ? numberAndUnit(each.name) : std::nullopt;
        return number && (number->unit.empty() || spelledLength(number->unit) || spellsOtherUnit(number->unit));
    };
    if (std::ranges::any_of(*cells, isNumber)) return std::nullopt;
    const std::string_view text = trimmed(withoutMark(line.text));
    const bool divided =
        text.find_first_of(table.separator == ' ' ? "\t" : std::string(1, table.separator)) != text.npos;
    Heading heading{&line, *cells, {}, divided};
    for (const HeadingCell& cell : *cells) heading.names.push_back(columnName(cell.name));
    // A comment is a heading if each word is known: "x (um), gap (nm)", not "spot size (mm), wavelength (um)"; and if
    // it names a place or a height: not "left (nm), right (um)".
    const bool order = heading.fits() || (heading.holdsNone() && heading.fits(0));
    const auto tells = [](const ColumnName& each) { return each.role != ColumnRole::Any; };
    const auto unnamed = [](const HeadingCell& each) { return each.name.empty(); }; // "units: um; nm"
    const bool list = heading.cells.size() > 1 && std::all_of(heading.cells.begin() + 1, heading.cells.end(), unnamed);
    const bool meant = heading.unitsAlone() || list || std::ranges::any_of(heading.names, tells);
    if (line.comment && !(heading.known() && order && meant)) return std::nullopt;
    if (line.comment && heading.holdsNone() && !heading.hasUnits() && &line != &table.headings.back())
        return std::nullopt; // "# scan speed"
    return heading;
}

[[noreturn]] void refuseNone(const Heading& heading, std::size_t i)
{
    const std::string& name = heading.cells[i].name;
    const bool height = i + 1 == heading.cells.size();
    throw CmlError(heading.line->line,
                   "names column " + std::to_string(i + 1) + " " + inQuotes(name) + ", which is no " +
                       (height ? "height" : "place on the disk") +
                       (heading.names[i].word == name ? "" : ": " + inQuotes(heading.names[i].word)));
}

/// Throws where the names do not fit the columns; unknown ones fit where the case gives the units.
void checkNames(const Heading& heading, bool byKey)
{
    for (std::size_t i = 0; i < heading.cells.size(); ++i)
        if (heading.names[i].role == ColumnRole::None) refuseNone(heading, i);
    for (std::size_t i = 0; i < heading.cells.size(); ++i) {
        if (heading.fits(i)) continue;
        if (heading.names[i].role != ColumnRole::Unknown)
            throw CmlError(heading.line->line,
                           "names the columns in another order; a profile has x and height, a map x, y and height");
        if (!byKey)
            throw CmlError(heading.line->line,
                           "names column " + std::to_string(i + 1) + " " + inQuotes(heading.cells[i].name) +
                               ", which is not known as a " + (i + 1 < heading.cells.size() ? "place" : "height") +
                               "; call the columns x and height, or x, y and height, or give disk.surface.unit");
    }
}

[[noreturn]] void refuseUnits(const Heading& heading)
{
    std::size_t count = 0;
    for (const HeadingCell& cell : heading.cells) {
        if (!cell.unit.empty() && !cell.metres)
            throw CmlError(heading.line->line, inQuotes(cell.unit) +
                                                   " is not clearly a unit of length, such as m, mm, um, nm or A; " +
                                                   asKey);
        count += cell.unit.empty() ? 0 : 1;
    }
    throw CmlError(heading.line->line, "names " + counted(count, "unit") + " for " +
                                           counted(heading.cells.size(), "column") + " of numbers; " + asKey);
}

/// By "lateral_unit: um" and "height_unit: nm".
std::optional<ColumnUnits> unitsOfValues(const HeaderValues& values, std::size_t columns)
{
    const auto x = lateralUnit(values), y = unitOfY(values);
    auto h = heightUnit(values);
    if (!h && columns == 2) h = y;
    if (!h || (columns > 1 && !x)) return std::nullopt;
    if (columns == 1) return ColumnUnits{*h};
    return columns == 2 ? ColumnUnits{*x, *h} : ColumnUnits{*x, y.value_or(*x), *h};
}

/// Units that stand in a sentence give none to a column.
[[noreturn]] void refuseWithoutUnits(const MapTable& table)
{
    constexpr std::string_view ends = " \t,;()[]{}:=/\"'";
    for (const HeadingLine& line : table.headings)
        for (std::size_t at = line.text.find_first_not_of(ends); at < std::min(line.text.size(), longestHeading);
             at = line.text.find_first_not_of(ends, at)) {
            const std::size_t end = std::min(line.text.find_first_of(ends, at), line.text.size());
            const std::string unit(trimmed(std::string_view(line.text).substr(at, end - at), "."));
            at = end;
            if (unit.size() > 1 && unit != "in" && spelledLength(unit))
                throw CmlError(line.line, "names the unit " + inQuotes(unit) +
                                              " in a remark, which gives no unit to a column: " + asKey);
        }
    throw CmlError(table.headings.empty() ? table.lines.front() : table.headings.back().line,
                   std::string("no unit is named: ") + asKey);
}

/// Names with words that are not known; a turned surface has a warning of its own.
std::vector<HeadingLine> doubtfulNames(const Heading& heading)
{
    std::vector<HeadingLine> doubts;
    const std::size_t count = heading.cells.size();
    for (std::size_t i = 0; i < count; ++i) {
        const ColumnName& name = heading.names[i];
        if (name.known && heading.fits(i)) continue;
        const bool height = i + 1 == count;
        if (height && name.turned) continue;
        doubts.push_back({"names column " + std::to_string(i + 1) + " " + inQuotes(heading.cells[i].name) +
                              ", which is not known: it was read as " + (height ? "heights, upwards" : "places"),
                          heading.line->line, heading.line->comment});
    }
    return doubts;
}

} // namespace

ColumnHeading columnHeading(const MapTable& table, const HeaderValues& values, const ColumnUnits& key)
{
    std::vector<Heading> all;
    for (const HeadingLine& line : table.headings)
        if (auto heading = headingOf(line, table)) all.push_back(std::move(*heading));
    // The names of the columns stand nearest to the numbers, if no line has names and units.
    const auto isNamed = [](const Heading& each) { return !each.unitsAlone(); };
    const auto isWhole = [&](const Heading& each) { return isNamed(each) && each.complete() && each.fits(); };
    const auto whole = std::find_if(all.rbegin(), all.rend(), isWhole);
    const auto last = whole != all.rend() ? whole : std::find_if(all.rbegin(), all.rend(), isNamed);
    const HeadingLine* const nearest = last == all.rend() ? nullptr : last->line;
    ColumnHeading found{key, {}, {}, {}};
    std::erase_if(all, [&](const Heading& each) { return each.isTitle(each.line == nearest); });
    int from = 0; // the line of the units
    const auto agree = [&](const ColumnUnits& units, int line) {
        if (found.units.empty()) {
            found.units = units;
            from = line;
        } else if (!same(units, found.units) && from == 0) {
            refuseOtherThanKey(line);
        } else if (!same(units, found.units)) {
            throw CmlError(line, "names other units than line " + std::to_string(from));
        }
    };
    const auto named = std::find_if(all.rbegin(), all.rend(), isNamed);
    if (named != all.rend()) {
        checkNames(*named, !key.empty());
        if (named->hasUnits() && !named->complete()) {
            for (std::size_t i = 0; i < table.columns; ++i) {
                const HeadingCell& cell = named->cells[i];
                if (key.empty() || (!cell.unit.empty() && !cell.metres)) refuseUnits(*named);
                if (cell.metres && !same({*cell.metres}, {key[i]})) refuseOtherThanKey(named->line->line);
            }
        }
    }
    for (const Heading& each : all) {
        if (each.complete() || each.line == nearest) found.lines.push_back(each.line->line);
        if (each.holdsNone()) checkNames(each, true);
        if (each.names.back().turned) found.turned = *each.line;
        if (each.complete() && each.fits())
            agree(each.units(), each.line->line);
        else if (each.unitsAlone() && each.hasUnits())
            refuseUnits(each);
    }
    if (const auto units = unitsOfValues(values, table.columns))
        agree(*units, values.has(HeaderField::HeightUnit) ? values.of(HeaderField::HeightUnit)->line
                                                          : table.headings.back().line);
    if (found.units.empty()) refuseWithoutUnits(table);
    if (named != all.rend()) found.doubts = doubtfulNames(*named);
    return found;
}

void takeOutIndex(MapTable& table)
{
    const double first = table.at(0, 0);
    if (table.columns < 2 || table.rows() < 3 || (first != 0.0 && first != 1.0)) return;
    for (std::size_t row = 0; row < table.rows(); ++row)
        if (table.at(row, 0) != first + static_cast<double>(row)) return;
    const auto heading = std::ranges::find_if(
        table.headings, [](const HeadingLine& each) { return namesIndex(each) && !isValue(each.text); });
    if (heading == table.headings.end()) {
        if (table.columns == 2) return;
        throw CmlError(table.lines.front(),
                       "the first column counts the rows; it is left out only where its heading is \"index\", \"#\", "
                       "\"no\", \"line\" or empty");
    }
    if (table.columns == 2) {
        const auto cells = headingCells(heading->text, table.separator, 2);
        if (cells && cells->front().metres) return; // "i [um], h [nm]"
        throw CmlError(heading->line, "the first column is an index; a profile needs the lengths x, too");
    }
    std::vector<double> numbers;
    numbers.reserve(table.rows() * (table.columns - 1));
    for (std::size_t row = 0; row < table.rows(); ++row)
        for (std::size_t column = 1; column < table.columns; ++column) numbers.push_back(table.at(row, column));
    table.numbers = std::move(numbers);
    --table.columns;
    table.indexed = true;
}

void refuseSecondChannel(const MapTable& table, bool matrix)
{
    const auto refuse = [](const HeadingLine& line, const char* what) {
        throw CmlError(line.line, what + std::string("; one profile or one channel is read from a file"));
    };
    std::size_t gaps = 0, inside = 0;
    for (const TableBreak& each : table.breaks) {
        const auto cells = isValue(each.line.text) || matrix
                               ? std::nullopt
                               : headingCells(each.line.text, table.separator, table.columns);
        const bool units =
            cells && std::ranges::any_of(*cells, [](const HeadingCell& cell) { return !cell.unit.empty(); });
        if (beginsChannel(each.line.text) || units) refuse(each.line, "a second channel or profile begins here");
        if (each.row >= table.rows()) continue;
        ++inside;
        if (each.line.text.empty()) ++gaps;
        if (matrix && !each.line.text.empty()) refuse(each.line, "a comment divides the matrix here");
    }
    const bool everyRow = gaps + 1 == table.rows() && table.rows() > 2; // lines that end twice
    if (matrix && inside > 0 && !everyRow) refuse(table.breaks.front().line, "an empty line divides the matrix here");
}

} // namespace touchdown
