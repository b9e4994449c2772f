// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/surface_heading.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/formats/cml_text.h"
#include "core/formats/quotation.h"
#include "core/formats/surfaces/surface_units.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

constexpr const char* asKey =
    "each column needs a unit of length, as \"x [um]  h [nm]\" in a heading, or the case gives them all, as "
    "disk.surface.unit = \"um, nm\"";
constexpr const char* oneChannel = "; one profile or one channel is read from a file";
constexpr std::string_view marks = "#%!/ \t\"'";

constexpr std::string_view indexNames[] = {"index", "idx", "no", "nr",    "n",      "i", "id",        "#",
                                           "num",   "row", "pt", "point", "number", "",  "unnamed: 0"};

constexpr std::string_view widthNames[] = {"width",  "image width", "scan width", "x size",  "x-size",     "xsize",
                                           "size x", "x range",     "x length",   "x-range", "x scan size"};
constexpr std::string_view heightNames[] = {"height", "image height", "scan height", "y size",  "y-size",     "ysize",
                                            "size y", "y range",      "y length",    "y-range", "y scan size"};
constexpr std::string_view valueNames[] = {"value units", "value unit", "values unit", "z units",    "z unit",
                                           "z-unit",      "z-units",    "height unit", "data units", "height units",
                                           "data unit",   "units",      "unit",        "value-units"};
constexpr std::string_view channelNames[] = {"channel", "channel name", "data channel", "profile"};

bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); }
bool same(const ColumnUnits& a, const ColumnUnits& b)
{
    return std::ranges::equal(a, b, [](double x, double y) { return same(x, y); });
}
bool contains(const ColumnUnits& units, double unit)
{
    return std::ranges::any_of(units, [&](double each) { return same(each, unit); });
}

/// "name: 16", "name = 16": a value with its name, no heading of columns.
bool isValue(std::string_view text)
{
    constexpr std::string_view index = "Unnamed: 0"; // as pandas writes it
    if (text.starts_with(index)) text.remove_prefix(index.size());
    for (std::size_t at = text.find_first_of(":="); at != std::string_view::npos;
         at = text.find_first_of(":=", at + 1)) {
        const std::size_t next = text.find_first_not_of(" \t+-.", at + 1);
        if (next != std::string_view::npos && text[next] >= '0' && text[next] <= '9') return true;
    }
    return false;
}

std::string_view withoutMarks(std::string_view text)
{
    return text.substr(std::min(text.find_first_not_of(marks), text.size()));
}

/// Whether the first cell of a heading is the name of an index, or empty.
bool namesIndex(const HeadingLine& heading)
{
    std::string_view text = heading.text;
    if (text.starts_with('#') && text.find_first_of(",;\t") != 1) text = withoutMarks(text);
    const std::string_view cell = text.substr(0, text.find_first_of(",;\t"));
    const auto named = [](std::string_view name) {
        name = trimmed(name.substr(0, name.find_first_of("[(")), " \t\"'.");
        return std::ranges::find(indexNames, lowerCase(name)) != std::end(indexNames);
    };
    if (cell.size() < text.size()) return named(cell);
    const std::string_view word = text.substr(0, text.find(' '));
    return !word.empty() && named(word);
}

/// What a heading says of units.
struct Named {
    const HeadingLine* heading = nullptr;
    std::vector<UnitMention> mentions;
    bool lengths = false; // all
    ColumnUnits units;
};

std::vector<Named> namedUnits(const MapTable& table)
{
    std::vector<Named> all;
    for (const HeadingLine& heading : table.headings) {
        if (isValue(heading.text)) continue;
        Named named{&heading, unitMentions(withoutMarks(heading.text)), true, {}};
        if (named.mentions.size() == table.columns + 1 && !named.mentions.front().metres && namesIndex(heading))
            named.mentions.erase(named.mentions.begin()); // "no [1]" of a column that was taken out
        for (const UnitMention& mention : named.mentions) {
            named.lengths = named.lengths && mention.metres;
            named.units.push_back(mention.metres.value_or(0.0));
        }
        if (!named.mentions.empty()) all.push_back(std::move(named));
    }
    return all;
}

[[noreturn]] void refuseUnits(const Named& named, std::size_t columns)
{
    for (const UnitMention& mention : named.mentions)
        if (!mention.metres)
            throw CmlError(named.heading->line, inQuotes(mention.text) +
                                                    " is not clearly a unit of length, such as m, mm, um, nm or A; " +
                                                    asKey);
    throw CmlError(named.heading->line, "names " + counted(named.units.size(), "unit") + " for " +
                                            counted(columns, "column") + " of numbers; " + asKey);
}

/// Columns are x, height or x, y, height; a heading that names them in another order is refused.
void refuseOtherOrder(const HeadingLine& heading, std::size_t columns)
{
    const std::string lower = lowerCase(heading.text);
    const auto place = [&](std::initializer_list<std::string_view> names) {
        constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz\xC2\xC3\xB5";
        for (std::size_t at = lower.find_first_of(letters); at != std::string::npos;
             at = lower.find_first_of(letters, at)) {
            const std::size_t end = std::min(lower.find_first_not_of(letters, at), lower.size());
            if (std::ranges::find(names, std::string_view(lower).substr(at, end - at)) != names.end()) return at;
            at = end;
        }
        return std::string::npos;
    };
    const std::size_t x = place({"x"}), y = place({"y"}), letter = place({"h", "z"});
    const std::size_t h = letter != std::string::npos ? letter : place({"height"});
    const bool after = x != std::string::npos && (y < x || h < x);
    if (after || (columns == 3 && y != std::string::npos && h < y))
        throw CmlError(heading.line, "names the columns in another order; a profile has x and height, a map x, y and "
                                     "height");
}

[[noreturn]] void refuseOtherThanKey(int line)
{
    throw CmlError(line, "names other units than disk.surface.unit; they must be the same, or one of them left out");
}

std::optional<HeadingValue> valueIn(std::string_view piece, std::span<const std::string_view> names, int line)
{
    const std::string_view text = withoutMarks(piece);
    const std::string lower = lowerCase(text);
    for (const std::string_view name : names) {
        if (!lower.starts_with(name)) continue;
        std::string_view rest = trimmed(text.substr(name.size()), blanks);
        HeadingValue value{{}, {}, line};
        if (rest.starts_with('[') || rest.starts_with('(')) {
            const std::size_t close = std::min(rest.find_first_of("])"), rest.size());
            value.unit = trimmed(rest.substr(1, close - 1));
            rest = trimmed(rest.substr(std::min(close + 1, rest.size())), blanks);
        }
        if (!rest.starts_with(':') && !rest.starts_with('=')) continue;
        value.value = trimmed(rest.substr(1), " \t\"'=");
        return value;
    }
    return std::nullopt;
}

/// "Width: 16 um, Height: 8 um" to its two parts.
std::vector<std::string_view> pieces(std::string_view text)
{
    std::vector<std::string_view> parts;
    std::size_t begin = 0;
    for (std::size_t at = text.find_first_of(",;"); at != std::string_view::npos;
         at = text.find_first_of(",;", at + 1)) {
        const std::size_t next = text.find_first_not_of(" \t", at + 1);
        const std::size_t colon = text.find_first_of(":=", at);
        const bool name = next != std::string_view::npos && colon != std::string_view::npos && next < colon &&
                          !(text[next] >= '0' && text[next] <= '9');
        if (!name) continue;
        parts.push_back(text.substr(begin, at - begin));
        begin = at + 1;
    }
    parts.push_back(text.substr(begin));
    return parts;
}

std::optional<HeadingValue> headingValue(const MapTable& table, std::span<const std::string_view> names)
{
    std::optional<HeadingValue> found;
    for (const HeadingLine& heading : table.headings)
        for (const std::string_view piece : pieces(heading.text)) {
            auto value = valueIn(piece, names, heading.line);
            if (!value) continue;
            if (found && (found->value != value->value || found->unit != value->unit))
                throw CmlError(heading.line, "gives " + inQuotes(value->value) + " after " + inQuotes(found->value) +
                                                 " in line " + std::to_string(found->line) + oneChannel);
            found = std::move(value);
        }
    return found;
}

/// The unit of a matrix, in the file or by the key.
double unitOf(const std::string& unit, double byKey, int line, const std::string& name)
{
    if (unit.empty()) {
        if (byKey > 0.0) return byKey;
        throw CmlError(line, name + " has no unit of length, as \"um\"; it needs one here, or the case gives all, as " +
                                 "disk.surface.unit = \"um, nm\" for the sides and the heights");
    }
    const auto metres = spelledLength(unit);
    if (!metres) throw CmlError(line, name + " must be a unit of length, as \"nm\", not " + inQuotes(unit));
    if (byKey > 0.0 && !same(*metres, byKey)) refuseOtherThanKey(line);
    return *metres;
}

} // namespace

std::optional<ColumnUnits> unitsOfKey(std::string_view text)
{
    ColumnUnits units;
    if (trimmed(text).empty()) return units;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find_first_of(",;", begin), text.size());
        const auto metres = spelledLength(trimmed(text.substr(begin, end - begin)));
        if (!metres) return std::nullopt;
        units.push_back(*metres);
        begin = end + 1;
    }
    return units;
}

ColumnUnits unitsOfKey(const ColumnUnits& key, std::size_t columns)
{
    if (key.empty() || key.size() == columns) return key;
    if (key.size() == 1) return ColumnUnits(columns, key.front());
    if (key.size() == 2 && columns == 3) return {key[0], key[0], key[1]};
    throw CmlError(0, "has " + counted(columns, "column") + ", and disk.surface.unit gives " +
                          counted(key.size(), "unit") + "; one for each column is needed, or one for all");
}

ColumnUnits columnUnits(const MapTable& table, const ColumnUnits& key)
{
    const ColumnUnits wanted = unitsOfKey(key, table.columns);
    const std::vector<Named> all = namedUnits(table);
    const auto complete = [&](const Named& each) { return each.lengths && each.units.size() == table.columns; };
    const auto first = std::ranges::find_if(all, complete);
    const ColumnUnits found = !wanted.empty() ? wanted : first != all.end() ? first->units : ColumnUnits{};
    for (const Named& each : all) {
        const bool heading = !each.heading->comment || &each == &all.back() || found.empty();
        if (complete(each)) {
            refuseOtherOrder(*each.heading, table.columns);
            if (same(each.units, found)) continue;
            if (!wanted.empty()) refuseOtherThanKey(each.heading->line);
            throw CmlError(each.heading->line, "names other units than line " + std::to_string(first->heading->line));
        }
        if (!heading || (each.heading->comment && first != all.end() && each.units.size() < table.columns)) continue;
        const bool part = each.lengths && each.units.size() < table.columns && !found.empty();
        if (!part) refuseUnits(each, table.columns);
        for (const double unit : each.units)
            if (!contains(found, unit)) {
                if (!wanted.empty()) refuseOtherThanKey(each.heading->line);
                refuseUnits(each, table.columns);
            }
    }
    if (!table.headings.empty() && !table.headings.back().comment)
        refuseOtherOrder(table.headings.back(), table.columns);
    if (!found.empty()) return found;
    throw CmlError(table.headings.empty() ? table.lines.front() : table.headings.back().line,
                   std::string("no unit is named: ") + asKey);
}

void takeOutIndex(MapTable& table)
{
    const double first = table.at(0, 0);
    if (table.rows() < 3 || (first != 0.0 && first != 1.0)) return;
    for (std::size_t row = 0; row < table.rows(); ++row)
        if (table.at(row, 0) != first + static_cast<double>(row)) return;
    const auto heading = std::ranges::find_if(
        table.headings, [](const HeadingLine& each) { return namesIndex(each) && !isValue(each.text); });
    if (heading == table.headings.end()) {
        if (table.columns == 2) return;
        throw CmlError(table.lines.front(),
                       "the first column counts the rows; it is left out only where its heading is \"index\", \"#\", "
                       "\"no\" or empty");
    }
    if (table.columns == 2) {
        const auto mentions = unitMentions(withoutMarks(heading->text));
        if (mentions.size() == 2 && mentions.front().metres) return; // "i [um], h [nm]"
        throw CmlError(heading->line, "the first column is an index; a profile needs the lengths x, too");
    }
    std::vector<double> numbers;
    numbers.reserve(table.rows() * (table.columns - 1));
    for (std::size_t row = 0; row < table.rows(); ++row)
        for (std::size_t column = 1; column < table.columns; ++column) numbers.push_back(table.at(row, column));
    table.numbers = std::move(numbers);
    --table.columns;
}

MatrixHeading matrixHeading(const MapTable& table)
{
    return {headingValue(table, widthNames), headingValue(table, heightNames), headingValue(table, valueNames)};
}

MatrixSize matrixSize(const MapTable& table, const MatrixHeading& heading, const ColumnUnits& key)
{
    const ColumnUnits units = key.empty() ? ColumnUnits(3, 0.0) : unitsOfKey(key, 3);
    const auto side = [](const HeadingValue& given, double byKey, const std::string& name) {
        const auto parts = numberAndUnit(given.value);
        const bool plain = parts && parts->number > 0.0 && (parts->unit.empty() || spelledLength(parts->unit));
        if (!plain)
            throw CmlError(given.line, name + " must be a length above 0 with its unit, as \"10 um\", not " +
                                           inQuotes(given.value));
        return parts->number * unitOf(parts->unit.empty() ? given.unit : parts->unit, byKey, given.line, name);
    };
    const HeadingValue none{{}, {}, table.lines.front()};
    const HeadingValue& value = heading.valueUnits ? *heading.valueUnits : none;
    const std::string unit(trimmed(value.value, " \t[](){}\"'"));
    return {side(*heading.width, units[0], "Width"), side(*heading.height, units[1], "Height"),
            unitOf(unit, units[2], value.line, "Value units")};
}

void refuseSecondChannel(const MapTable& table, bool matrix)
{
    const std::span<const std::string_view> all[] = {widthNames, heightNames, valueNames, channelNames};
    const auto refuse = [](const HeadingLine& line, const char* what) {
        throw CmlError(line.line, what + std::string(oneChannel));
    };
    std::size_t gaps = 0, inside = 0;
    for (const TableBreak& each : table.breaks) {
        const bool names = std::ranges::any_of(
            all, [&](const auto& list) { return valueIn(each.line.text, list, each.line.line).has_value(); });
        const bool units = !isValue(each.line.text) && !unitMentions(withoutMarks(each.line.text)).empty();
        if (names || units) refuse(each.line, "a second channel or profile begins here");
        if (each.row >= table.rows()) continue;
        ++inside;
        if (each.line.text.empty()) ++gaps;
        if (matrix && !each.line.text.empty()) refuse(each.line, "a comment divides the matrix here");
    }
    const bool everyRow = gaps + 1 == table.rows() && table.rows() > 2; // lines that end twice
    if (matrix && inside > 0 && !everyRow) refuse(table.breaks.front().line, "an empty line divides the matrix here");
}

} // namespace touchdown
