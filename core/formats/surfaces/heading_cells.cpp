// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/heading_cells.h"

#include <algorithm>
#include <utility>

#include "core/formats/surfaces/column_name.h"
#include "core/formats/surfaces/surface_units.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

constexpr std::string_view aroundCell = " \t\"'";
constexpr std::string_view brackets = "([{<";

bool isLength(std::string_view word) { return spelledLength(word).has_value(); }
/// Symbols that are also a name or a word.
bool mayBeName(std::string_view word) { return word == "A" || word == "m" || word == "in"; }

char closing(char open)
{
    switch (open) {
    case '(': return ')';
    case '[': return ']';
    case '{': return '}';
    default: return '>';
    }
}

/// The parts between the separators that stand outside of brackets and quotation marks.
std::vector<std::string_view> divided(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    std::size_t begin = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"') quoted = !quoted;
        if (!quoted && brackets.find(text[i]) != std::string_view::npos) {
            const std::size_t close = text.find(closing(text[i]), i);
            if (close != std::string_view::npos) i = close;
        } else if (!quoted && text[i] == separator) {
            parts.push_back(text.substr(begin, i - begin));
            begin = i + 1;
        }
    }
    parts.push_back(text.substr(begin));
    if (parts.size() > 1 && trimmed(parts.back(), aroundCell).empty()) parts.pop_back(); // "x;h;"
    return parts;
}

/// A remark, "(forward)", "(2)", and no unit.
bool isRemark(std::string_view content)
{
    if (content.find_first_not_of(decimalDigits) == std::string_view::npos) return true;
    const bool mixed = content.find_first_of(decimalDigits) != std::string_view::npos;
    return !mixed && content.size() > 1 && !spellsOtherUnit(content) && columnName(content).known;
}

/// Takes the brackets out of a cell: one unit of length, remarks, and words that are neither, which a unit of length
/// makes remarks. A number, another unit or text behind the unit spoils it: "(x10) [nm]", "[nm] / 10".
std::string withoutBrackets(std::string_view text, HeadingCell& cell)
{
    std::string name, word, spoiled;
    for (std::size_t open = text.find_first_of(brackets); open != std::string_view::npos;
         open = text.find_first_of(brackets)) {
        const std::size_t close = std::min(text.find(closing(text[open]), open), text.size());
        std::string_view content = trimmed(text.substr(open + 1, close - open - 1), aroundCell);
        if (content.starts_with("in ")) content = trimmed(content.substr(3));
        name += text.substr(0, open);
        if (const auto metres = spelledLength(content)) {
            if (cell.metres && *cell.metres != *metres) spoiled = content;
            cell.unit = content;
            cell.metres = metres;
        } else if (open == 0 && name.empty() && text[open] == '(' && content == "-") { // "(-) z [nm]"
            name = "-";
        } else if (text[open] == '(' && isRemark(content)) {
            name.append(" ").append(content);
        } else if (spellsOtherUnit(content) || content.find_first_of(decimalDigits) != std::string_view::npos) {
            spoiled = content;
        } else if (!content.empty()) {
            word = content;
        }
        text.remove_prefix(std::min(close + 1, text.size()));
        const std::string_view behind = trimmed(text.substr(0, text.find_first_of(brackets)), " \t\"':.");
        if (!cell.unit.empty() && !behind.empty()) spoiled = cell.unit + ' ' + std::string(behind);
    }
    if (!spoiled.empty() || (!cell.metres && !word.empty())) {
        cell.unit = spoiled.empty() ? word : spoiled;
        cell.metres = std::nullopt;
    } else if (!word.empty()) {
        name.append(" ").append(word); // "h (AFM) [nm]"
    }
    return cell.unit.empty() ? name.append(text) : name;
}

/// Whether the part of `text` behind `at` is a unit, which then leaves it.
bool takeUnit(std::string& text, std::size_t at, std::size_t length, HeadingCell& cell)
{
    const std::string unit(trimmed(std::string_view(text).substr(at + length), aroundCell));
    const auto metres = spelledLength(unit);
    if (!metres && !spellsOtherUnit(unit)) return false;
    cell.unit = unit;
    cell.metres = metres;
    text.resize(at);
    return true;
}

/// Whether the words before a unit may belong to it: "x micro", "x u", "x 1e-6".
bool endsWithFactor(std::string_view text)
{
    constexpr std::string_view prefixes[] = {"micro", "mikro", "nano", "pico", "milli", "centi", "mu"};
    text = trimmed(text, aroundCell);
    const std::size_t blank = text.find_last_of(" \t");
    const std::string word = lowerCase(text.substr(blank == std::string_view::npos ? 0 : blank + 1));
    const bool letter = word.size() == 1 && blank != std::string_view::npos && !columnName(text).known;
    return letter || word.find_first_of(decimalDigits) != std::string::npos ||
           std::ranges::find(prefixes, word) != std::end(prefixes);
}

/// A unit without brackets: "x in um", "x/um", "x, um", "x: um", "x_um", "x um". False where the words before it may
/// belong to it: "x micro m".
bool takeBareUnit(std::string& text, HeadingCell& cell)
{
    if (const auto in = text.rfind(" in "); in != std::string::npos && takeUnit(text, in, 4, cell)) return true;
    for (const char sign : {'/', ',', ':', '='})
        if (const auto at = text.rfind(sign); at != std::string::npos && at > 0 && takeUnit(text, at, 1, cell))
            return true;
    const std::size_t blank = text.find_last_of(" \t");
    if (const auto mark = text.find_last_not_of("._-"); mark != std::string::npos) {
        const std::size_t joint = text.find_last_of("._-", mark);
        const bool within =
            joint != std::string::npos && joint > 0 && (blank == std::string::npos || joint > blank + 1);
        std::string bare = text.substr(0, mark + 1); // "x..um."
        if (within && bare.substr(joint + 1) != "in" && takeUnit(bare, joint, 1, cell)) {
            text = bare.ends_with("_in") ? bare.substr(0, bare.size() - 3) : bare;
            return true;
        }
    }
    const std::string_view last = std::string_view(text).substr(blank == std::string::npos ? text.size() : blank + 1);
    if (last.size() < 2 && last != "m") return true;
    if (last == "in" || !takeUnit(text, blank, 1, cell)) return true;
    return !endsWithFactor(text);
}

std::optional<HeadingCell> cellOf(std::string_view text)
{
    HeadingCell cell;
    text = trimmed(text, aroundCell);
    if (isLength(text) || (text.size() > 1 && spellsOtherUnit(text))) {
        cell.unit = text;
        cell.metres = spelledLength(text);
        return cell;
    }
    std::string name = withoutBrackets(text, cell);
    name = trimmed(name, aroundCell);
    const auto twoBlanks = [](char a, char b) { return a == ' ' && b == ' '; };
    name.erase(std::unique(name.begin(), name.end(), twoBlanks), name.end());
    if (cell.unit.empty() && !takeBareUnit(name, cell)) return std::nullopt;
    cell.name = trimmed(name, " \t\"':=._");
    return cell;
}

std::optional<HeadingCells> cellsOf(const std::vector<std::string_view>& parts, std::size_t columns)
{
    if (parts.size() != columns) return std::nullopt;
    HeadingCells cells;
    for (const std::string_view part : parts) {
        auto cell = cellOf(part);
        if (!cell) return std::nullopt;
        cells.push_back(std::move(*cell));
    }
    const bool named = std::ranges::any_of(cells, [](const HeadingCell& each) { return !each.name.empty(); });
    for (HeadingCell& cell : cells)
        if (cell.name.empty() && (named && mayBeName(cell.unit))) { // "x, A"
            cell.name = std::exchange(cell.unit, {});
            cell.metres = std::nullopt;
        } else if (!named && !cell.metres) {
            return cells; // "ms, nm"
        }
    const bool units = std::ranges::any_of(cells, [](const HeadingCell& each) { return each.name.empty(); });
    for (HeadingCell& cell : cells)
        if (units && cell.unit.empty() && spellsOtherUnit(cell.name))
            cell.unit = std::exchange(cell.name, {}); // "um, V"
    return cells;
}

/// The words of a line, each with the unit behind it.
std::vector<std::string_view> wordsOf(std::string_view text, bool unitsEnd)
{
    std::vector<std::string_view> words;
    std::size_t begin = 0, end = 0;
    bool open = false, joins = false; // the cell is without unit; "/" or "in" asks for the next word
    for (std::size_t at = text.find_first_not_of(" \t"); at < text.size(); at = text.find_first_not_of(" \t", at)) {
        std::size_t stop = std::min(text.find_first_of(" \t", at), text.size());
        if (const auto bracket = text.find_first_of(brackets, at); bracket < stop) {
            const std::size_t close = text.find(closing(text[bracket]), bracket);
            if (close != std::string_view::npos) stop = std::min(text.find_first_of(" \t", close), text.size());
        }
        const std::string_view word = text.substr(at, stop - at);
        const bool bracket = brackets.find(word.front()) != std::string_view::npos;
        const bool joint = word == "/" || word == "in" || word == "[" || word == ":";
        const bool unit = isLength(word) && !mayBeName(word);
        const bool further = open && (bracket || joint || joins || unit || unitsEnd);
        if (!further) {
            if (end > begin) words.push_back(text.substr(begin, end - begin));
            begin = at;
        }
        end = stop;
        const auto cell = cellOf(text.substr(begin, end - begin));
        open = !cell || cell->unit.empty() || joint;
        joins = joint;
        at = stop;
    }
    if (end > begin) words.push_back(text.substr(begin, end - begin));
    return words;
}

/// "x, h [um, nm]", "[um, nm]"
std::optional<HeadingCells> listed(std::string_view text, char separator, std::size_t columns)
{
    text = trimmed(text, aroundCell);
    const std::size_t open = text.find_last_of(brackets);
    if (columns < 2 || open == std::string_view::npos || text.find(closing(text[open]), open) != text.size() - 1)
        return std::nullopt;
    const std::string_view list = text.substr(open + 1, text.size() - open - 2);
    const auto units = cellsOf(divided(list, list.find(';') != std::string_view::npos ? ';' : ','), columns);
    const auto plain = [](const HeadingCell& each) { return each.name.empty() && each.metres; };
    if (!units || !std::ranges::all_of(*units, plain)) return std::nullopt;
    HeadingCells cells = *units;
    const std::string_view names = trimmed(text.substr(0, open), " \t\"':=");
    if (names.empty()) return cells;
    const auto named = headingCells(names, separator, columns);
    if (!named) return std::nullopt;
    for (std::size_t i = 0; i < columns; ++i) {
        if (!(*named)[i].unit.empty()) return std::nullopt;
        cells[i].name = (*named)[i].name;
    }
    return cells;
}

std::optional<HeadingCells> wholeLine(std::string_view text, char separator, std::size_t columns)
{
    if (auto cells = listed(text, separator, columns)) return cells;
    if (separator != ' ' && divided(text, separator).size() > 1) return cellsOf(divided(text, separator), columns);
    for (const char other : {'\t', ';', ',', '|'})
        if (const auto parts = divided(text, other); parts.size() > 1 && parts.size() == columns)
            return cellsOf(parts, columns);
    if (columns == 1) return cellsOf({text}, columns);
    for (const bool unitsEnd : {false, true})
        if (const auto words = wordsOf(text, unitsEnd); words.size() == columns) return cellsOf(words, columns);
    return std::nullopt;
}

} // namespace

std::string_view withoutMark(std::string_view line)
{
    const std::size_t begin = std::min(line.find_first_not_of(" \"'"), line.size());
    const std::string_view text = line.substr(begin);
    const bool comment =
        text.starts_with('#') || text.starts_with('%') || text.starts_with('!') || text.starts_with("//");
    const bool column = text.starts_with('#') && text.find_first_of(",;\t") == 1; // "#;x;h" of an index
    if (!comment || column) return line;
    return text.substr(std::min(text.find_first_not_of("#%!/ "), text.size()));
}

std::optional<HeadingCells> headingCells(std::string_view line, char separator, std::size_t columns)
{
    if (line.size() > longestHeading) return std::nullopt;
    const std::string text = withPlainLetters(withoutMark(line));
    if (auto cells = wholeLine(text, separator, columns)) return cells;
    // "columns: x, h", "exported by a tool (x in um, h in nm)"
    const std::string_view all = text;
    if (const auto colon = all.find(':'); colon != std::string_view::npos)
        if (auto cells = wholeLine(all.substr(colon + 1), separator, columns)) return cells;
    const std::string_view end = trimmed(all);
    if (const auto open = end.find('('); end.ends_with(')') && open != std::string_view::npos && columns > 1)
        return wholeLine(end.substr(open + 1, end.size() - open - 2), separator, columns);
    return std::nullopt;
}

} // namespace touchdown
