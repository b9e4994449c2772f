// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/map_table.h"

#include <algorithm>
#include <optional>

#include "core/formats/cml_text.h"
#include "core/formats/quotation.h"
#include "core/formats/surfaces/column_name.h"
#include "core/formats/words.h"
#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

namespace {

constexpr std::string_view cellEnds = " \t,;\v\f";
constexpr std::string_view aroundCells = " \t\v\f\"'";
constexpr std::size_t longestTableLine = 1 << 24;   // [byte]; room for a million numbers
constexpr std::size_t mostBetweenNumbers = 1 << 26; // headings, comments and empty lines [byte]

bool isComment(std::string_view line)
{
    line = line.substr(std::min(line.find_first_not_of("\"'"), line.size()));
    return line.starts_with('#') || line.starts_with('%') || line.starts_with('!') || line.starts_with("//");
}

/// "nan", "-inf", "NA" and other marks for a missing measurement.
bool standsForHole(std::string_view word)
{
    static constexpr std::string_view marks[] = {"nan", "inf", "infinity", "na",   "n/a",     "#n/a", "bad",    "-",
                                                 "--",  "---", "*",        "null", "missing", "none", "invalid"};
    const std::string lower = lowerCase(word);
    const std::string_view bare = lower.starts_with('-') || lower.starts_with('+') ? word.substr(1) : word;
    return std::ranges::find(marks, lower) != std::end(marks) ||
           std::ranges::find(marks, lowerCase(bare)) != std::end(marks) || lowerCase(bare).starts_with("1.#") ||
           lowerCase(bare).starts_with("nan(");
}

bool isNumber(std::string_view cell) { return readCmlNumber(trimmed(cell, aroundCells)).has_value(); }

/// "2024-01-05"
bool isDate(std::string_view word)
{
    const bool plain = word.find_first_not_of("0123456789-") == std::string_view::npos;
    return plain && !word.starts_with('-') && std::ranges::count(word, '-') == 2;
}

bool holesAlone(std::string_view line)
{
    for (std::size_t at = line.find_first_not_of(cellEnds); at < line.size();
         at = line.find_first_not_of(cellEnds, at)) {
        const std::size_t end = std::min(line.find_first_of(cellEnds, at), line.size());
        if (!standsForHole(trimmed(line.substr(at, end - at), aroundCells))) return false;
        at = end;
    }
    return true;
}

/// Whether a line before the first one of numbers is that first one already.
bool isRow(std::string_view line)
{
    const std::string_view first = trimmed(line.substr(0, line.find_first_of(cellEnds)), aroundCells);
    if (readCmlNumber(first)) return true;
    if (standsForHole(first)) return line.find_first_of(decimalDigits) != std::string_view::npos || holesAlone(line);
    if (isDate(first) || line.find_first_of(decimalDigits) == std::string_view::npos) return false;
    if (line.find_first_not_of("0123456789+-.,;eEdD \t\"'") == std::string_view::npos) return true;
    std::size_t cells = 0, numbers = 0; // a row of a matrix that begins with an unknown mark
    for (std::size_t at = line.find_first_not_of(cellEnds); at < line.size();
         at = line.find_first_not_of(cellEnds, at)) {
        const std::size_t end = std::min(line.find_first_of(cellEnds, at), line.size());
        numbers += isNumber(line.substr(at, end - at)) ? 1 : 0;
        ++cells;
        at = end;
    }
    return cells >= 4 && 2 * numbers > cells;
}

struct Row {
    std::string_view text;
    int line = 0;
};

/// How the numbers of a file are written.
struct NumberFormat {
    char separator = ' '; // a blank: blanks and tabs
    bool decimalComma = false;
    bool point = false; // a number has one
};

/// Looks at the commas of all rows.
class FormatOfRows {
public:
    explicit FormatOfRows(const std::vector<Row>& rows)
    {
        for (const Row& row : rows) look(row);
    }

    /// Whether whole numbers may be halves of decimals: a comma has a digit on both sides.
    bool commaBetweenDigits() const { return between_ > 0; }

    NumberFormat format() const
    {
        const bool several = semicolon_ || blank_ || quoted_ > 0;
        const bool decimal = (between_ > 0 && (semicolon_ || blank_)) || leading_ > 0 || quoted_ > 0;
        const bool afterBlank = afterBlank_ && between_ == 0; // "1 ,5"
        if (decimal && (!several || point_ || afterBlank || (quoted_ > 0 ? between_ + leading_ : separating_) > 0))
            throw CmlError(std::max({between_ > 0 ? between_ : leading_, quoted_}),
                           "has commas that may be decimal commas, separators or thousands separators; write decimals "
                           "with a point, or separate the numbers by semicolons or tabs");
        if (decimal && !clearDecimal_)
            throw CmlError(std::max({between_, leading_, quoted_}),
                           "has a comma before three digits in each number, which may separate thousands; write "
                           "decimals with a point");
        const bool comma = separating_ > 0 || (between_ > 0 && !decimal);
        return {semicolon_ ? ';' : comma ? ',' : ' ', decimal, point_};
    }

private:
    void look(const Row& row)
    {
        const std::string_view text = row.text;
        const auto note = [&](int& line) { line = line > 0 ? line : row.line; };
        const auto isDigitAt = [&](std::size_t i) {
            return i < text.size() && decimalDigits.find(text[i]) != std::string_view::npos;
        };
        bool quoted = false;
        for (std::size_t i = 0; i < text.size(); ++i) {
            const char c = text[i];
            if (c == '"') quoted = !quoted;
            if (c == '.') point_ = true;
            if (c == ';' && !quoted) semicolon_ = true;
            const bool first = i == 0 || (text[i - 1] != ' ' && text[i - 1] != '\t'); // of several blanks
            if ((c == ' ' || c == '\t') && !quoted && first) blank_ = blank_ || dividesNumbers(text, i);
            if (c != ',') continue;
            const bool before = i > 0 && isDigitAt(i - 1), after = isDigitAt(i + 1);
            const char left = i > 0 ? text[i - 1] : ' ';
            if (quoted)
                note(quoted_);
            else if (before && after)
                note(between_);
            else if (after && std::string_view(" \t;+-").find(left) != std::string_view::npos)
                note(leading_), afterBlank_ = afterBlank_ || (left == ' ' && i > 0);
            else
                note(separating_);
            if (!after) continue;
            const std::size_t begin = text.find_last_not_of(decimalDigits, i - (i > 0 ? 1 : 0)) + 1;
            const std::size_t end = std::min(text.find_first_not_of(decimalDigits, i + 1), text.size());
            if (!before || !mayCountThousands(text.substr(begin, end - begin))) clearDecimal_ = true;
        }
    }

    /// Not a blank beside another separator.
    static bool dividesNumbers(std::string_view text, std::size_t at)
    {
        const auto left = text.find_last_not_of(" \t", at), right = text.find_first_not_of(" \t", at);
        if (left == std::string_view::npos || right == std::string_view::npos) return false;
        const auto separates = [](char c) { return c == ',' || c == ';'; };
        // ",5" after a tab is a number.
        const bool number =
            text[right] == ',' && right + 1 < text.size() && decimalDigits.find(text[right + 1]) < decimalDigits.size();
        return !separates(text[left]) && (!separates(text[right]) || number);
    }

    bool semicolon_ = false, blank_ = false, point_ = false, clearDecimal_ = false, afterBlank_ = false;
    int between_ = 0, leading_ = 0, separating_ = 0, quoted_ = 0; // commas: the line of the first one, or 0
};

/// The cells of a line. `inQuotes` separators do not count.
void splitRow(std::string_view line, char separator, std::vector<std::string_view>& cells)
{
    cells.clear();
    bool quoted = false;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        const bool end = i == line.size();
        if (!end && line[i] == '"') quoted = !quoted;
        const bool divides =
            end || (!quoted && (separator == ' ' ? std::string_view(" \t\v\f").find(line[i]) != std::string_view::npos
                                                 : line[i] == separator));
        if (!divides) continue;
        const std::string_view cell = trimmed(line.substr(begin, i - begin), aroundCells);
        if (separator != ' ' || !cell.empty()) cells.push_back(cell);
        begin = i + 1;
    }
    if (separator != ' ' && cells.back().empty()) cells.pop_back(); // "1;2;"
}

double readCell(std::string_view cell, const NumberFormat& format, int line)
{
    std::optional<double> value;
    if (const auto comma = cell.find(','); format.decimalComma && comma != std::string_view::npos) {
        std::string decimal(cell);
        decimal[comma] = '.';
        value = readCmlNumber(decimal);
    } else {
        value = readCmlNumber(cell);
    }
    if (value) return *value;
    if (cell.empty()) throw CmlError(line, "a surface has no holes: a number is missing between two separators");
    if (standsForHole(cell))
        throw CmlError(line, "a surface has no holes: every height must be a number, not " + inQuotes(cell));
    throw CmlError(line, "a line of numbers is needed, not " + inQuotes(cell));
}

/// "1,5,2,5": whole numbers in pairs, the second of each without a sign.
bool mayBePairs(const std::vector<std::string_view>& cells)
{
    if (cells.size() < 4 || cells.size() % 2 != 0) return false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        std::string_view cell = cells[i];
        if (i % 2 == 0 && !cell.empty() && (cell[0] == '-' || cell[0] == '+')) cell.remove_prefix(1);
        const std::size_t end = std::min(cell.find_first_not_of(decimalDigits), cell.size());
        const bool exponent = i % 2 == 1 && end < cell.size() && (cell[end] == 'e' || cell[end] == 'E');
        if (end == 0 || (end < cell.size() && !exponent)) return false;
    }
    return true;
}

/// Divides the text into headings, rows and the lines between them.
std::vector<Row> findRows(std::string_view text, MapTable& table)
{
    std::vector<Row> rows;
    std::size_t between = 0;
    for (CmlText reader(text); !reader.atEnd();) {
        const int number = reader.line();
        const std::string_view whole = reader.takeLine();
        if (whole.size() > longestTableLine) throw CmlError(number, "is longer than 16 MiB, the most of a line");
        const std::string_view line = trimmed(whole, " \t\v\f");
        const bool comment = isComment(line);
        if (line.empty() || comment || rows.empty()) between += whole.size() + 16;
        if (between > mostBetweenNumbers)
            throw CmlError(number, "more than 64 MiB of headings, comments and empty lines are here or before");
        if (!rows.empty() && (line.empty() || comment)) {
            if (!line.empty() || table.breaks.empty() || table.breaks.back().row != rows.size())
                table.breaks.push_back({rows.size(), {std::string(line), number, comment}});
        } else if (comment || (rows.empty() && !line.empty() && !isRow(line))) {
            table.headings.push_back({std::string(whole), number, comment});
        } else if (!line.empty()) {
            const std::string_view first = trimmed(line.substr(0, line.find_first_of(cellEnds)), aroundCells);
            if (!isRow(line) && !first.empty())
                throw CmlError(number, "a line of numbers is needed, not " + inQuotes(first) +
                                           "; one profile or one channel is read from a file, no second one");
            rows.push_back({line, number});
            if (rows.size() > static_cast<std::size_t>(mostMapPoints))
                throw CmlError(number, "there are too many points; at most 64 million can be read");
        }
    }
    return rows;
}

} // namespace

bool mayCountThousands(std::string_view number)
{
    if (number.starts_with('-') || number.starts_with('+')) number.remove_prefix(1);
    const std::size_t comma = number.find(',');
    return comma != std::string_view::npos && comma >= 1 && comma <= 3 && number[0] != '0' &&
           number.size() == comma + 4 && number.find_first_not_of(decimalDigits, comma + 1) == std::string_view::npos;
}

void refuseShortRow(const MapTable& table)
{
    if (table.shortLine == 0) return;
    throw CmlError(table.shortLine, "has " + counted(table.shortRow.size(), "number") + ", the lines before it " +
                                        std::to_string(table.columns) +
                                        "; a surface has no holes: every line must be complete");
}

MapTable readMapTable(std::string_view written)
{
    constexpr std::string_view longMinus = "\xE2\x88\x92";
    std::string plain; // only where there is one
    for (std::size_t at = written.find(longMinus), begin = 0; begin < written.size();) {
        if (at == std::string_view::npos && plain.empty()) break;
        plain.append(written.substr(begin, at - begin)).append(at == std::string_view::npos ? "" : "-");
        begin = std::min(at, written.size() - longMinus.size()) + longMinus.size();
        at = written.find(longMinus, begin);
    }
    const std::string_view text = plain.empty() ? written : plain;
    MapTable table;
    const std::vector<Row> rows = findRows(text, table);
    const FormatOfRows commas(rows);
    const NumberFormat format = commas.format();
    table.separator = format.separator;
    bool pairs = commas.commaBetweenDigits() && format.separator == ',' && !format.point && !format.decimalComma;
    std::vector<std::string_view> cells;
    std::vector<double> row;
    for (const Row& each : rows) {
        refuseShortRow(table);
        splitRow(each.text, format.separator, cells);
        row.clear();
        for (const std::string_view cell : cells) row.push_back(readCell(cell, format, each.line));
        pairs = pairs && mayBePairs(cells);
        if (table.rows() == 0) table.columns = row.size();
        if (row.size() != table.columns) {
            table.shortRow = row;
            table.shortLine = each.line;
            continue;
        }
        table.numbers.insert(table.numbers.end(), row.begin(), row.end());
        table.lines.push_back(each.line);
        if (table.numbers.size() > 4 * static_cast<std::size_t>(mostMapPoints))
            throw CmlError(each.line, "there are too many points; at most 64 million can be read");
    }
    if (table.rows() == 0 || table.columns == 0)
        throw CmlError(0,
                       "holds no numbers; a profile has two columns, x and height, and a map three, x, y and height");
    if (pairs)
        throw CmlError(table.lines.front(),
                       "has commas that may separate whole numbers or be decimal commas; write decimals with a point, "
                       "or separate the numbers by semicolons or tabs");
    return table;
}

} // namespace touchdown
