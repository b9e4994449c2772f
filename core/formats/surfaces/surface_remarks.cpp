// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/surface_remarks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ranges>
#include <string>
#include <utility>

#include "core/formats/surfaces/column_name.h"
#include "core/formats/surfaces/heading_cells.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

constexpr std::size_t mostRemarks = 10; // that are reported
constexpr std::size_t mostRemarksRead = 200;

/// What the remarks are compared with.
struct FileFacts {
    const MapTable& table;
    ColumnUnits units; // of the columns [m], that of the heights last
    bool matrix = false;
    ColumnUnits others{}; // of lengths that were read [m]

    bool knows(double metres) const
    {
        const auto same = [=](double u) { return std::abs(u - metres) <= 1e-9 * metres; };
        return std::ranges::any_of(units, same) || std::ranges::any_of(others, same);
    }
    /// Whether the file has so many points, lines or columns.
    bool has(double count) const
    {
        const auto rows = static_cast<double>(table.rows()), columns = static_cast<double>(table.columns);
        const bool share = !matrix && table.columns == 3 && count >= 1.0 && std::fmod(rows, count) == 0.0;
        return share || count == rows || (matrix && (count == columns || count == rows * columns));
    }
};

/// The words, numbers and units of a clause.
std::vector<std::string_view> tokens(std::string_view text)
{
    constexpr std::string_view ends = " \t()[]{}:=\"'";
    std::vector<std::string_view> all;
    for (std::size_t at = text.find_first_not_of(ends); at < text.size(); at = text.find_first_not_of(ends, at)) {
        const std::size_t end = std::min(text.find_first_of(ends, at), text.size());
        if (const auto token = trimmed(text.substr(at, end - at), ".,;!?"); !token.empty()) all.push_back(token);
        at = end;
    }
    return all;
}

bool beginsWithDigit(std::string_view token)
{
    const std::size_t sign = token.starts_with('-') || token.starts_with('+') ? 1 : 0;
    return sign < token.size() && decimalDigits.find(token[sign]) < decimalDigits.size();
}

bool isUnitWord(std::string_view token)
{
    const std::string_view first = token.substr(0, token.find_first_of("/^"));
    return spelledLength(first) || spellsOtherUnit(first);
}

/// Whether a clause gives a figure, "pit depth: 3 nm", "tip 2": it ends with a number, perhaps with its unit.
bool endsWithFigure(const std::vector<std::string_view>& all)
{
    if (all.empty()) return false;
    return beginsWithDigit(all.back()) ||
           (all.size() > 1 && isUnitWord(all.back()) && beginsWithDigit(all[all.size() - 2]));
}

/// "in pm", "[V]", "in waves", "in units of 2 nm" beside a word for heights, "in V" beside one for data, where the
/// columns have other units.
bool namesOtherUnit(std::string_view clause, bool height, const FileFacts& file)
{
    const auto all = tokens(clause);
    const auto isHeight = [&](std::size_t i) {
        const auto words = wordsWithMeaning(all[i]);
        return words.size() == 1 && words[0].meaning == WordMeaning::Height;
    };
    const auto unit = std::ranges::find_if(all, [](std::string_view each) { return each.starts_with("unit"); });
    if (height && std::any_of(unit, all.end(), beginsWithDigit)) return true;
    for (std::size_t i = 1; i < all.size(); ++i) {
        const std::string_view word = all[i];
        const bool behindIn = all[i - 1] == "in" && i > 1, letter = word == "A" || word == "m" || word == "in";
        const bool bracketed = clause.find('[' + std::string(word) + ']') != std::string_view::npos;
        if (!bracketed && (beginsWithDigit(word) || beginsWithDigit(all[i - 1]))) continue;
        if (!bracketed && (!(height || behindIn) || (letter && !behindIn))) continue;
        if (const auto metres = spelledLength(word)) {
            const bool ofHeights = behindIn && isHeight(i - 2);
            if (ofHeights ? std::abs(*metres - file.units.back()) > 1e-9 * *metres : !file.knows(*metres)) return true;
            continue;
        }
        if (spellsOtherUnit(word) && (word.size() > 1 || word == "V" || word == "%") && word != "min") return true;
        if (!behindIn || !height) continue;
        const auto words = wordsWithMeaning(word);
        const bool verb = all[i - 2] == "are" || all[i - 2] == "is" || all[i - 2] == "sind";
        const bool unknown = words.size() == 1 && words[0].meaning == WordMeaning::Unknown && word.size() > 1;
        if (unknown && (verb || isHeight(i - 2))) return true;
    }
    return false;
}

/// "z x10", "z * 10", "z / 10", "z times 10", "z^2", "z = -h".
bool holdsFactorSign(std::string_view text)
{
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        const bool sign = text[i] == '*' || text[i] == '/' || text[i] == 'x' || text[i] == 'X';
        const std::size_t left = text.find_last_not_of(' ', i - 1), right = text.find_first_not_of(' ', i + 1);
        if (!sign || left == std::string_view::npos || right == std::string_view::npos) continue;
        const bool letter = text[i] == 'x' || text[i] == 'X';
        const bool apart = !letter || text[i - 1] == ' ';
        if (apart && beginsWithDigit(text.substr(right, 1)) && !beginsWithDigit(text.substr(left, 1)) &&
            text.substr(0, left + 1).find_first_not_of(" #%") != std::string_view::npos)
            return true;
    }
    if (const auto equals = text.find('='); equals != std::string_view::npos) {
        const std::string_view right = trimmed(text.substr(equals + 1));
        if (right.starts_with('-') && !beginsWithDigit(right)) return true;
    }
    const auto times = text.find(" times ");
    if (times != std::string_view::npos && beginsWithDigit(text.substr(times + 7))) return true;
    return text.find('^') != std::string_view::npos || text.find("\xC2\xB2") != std::string_view::npos ||
           text.find("\xC3\x97") != std::string_view::npos;
}

/// "32 x 16 points", "Points: 128" of a file with other counts.
bool countsOtherwise(const std::vector<std::string_view>& all, const FileFacts& file)
{
    constexpr std::string_view counted[] = {"points", "pixels", "px",      "samples", "rows",      "values",
                                            "punkte", "zeilen", "spalten", "columns", "messpunkte"};
    constexpr std::string_view beside[] = {"x",      "by",   "number", "of",   "total",  "data", "per",
                                           "line",   "size", "map",    "grid", "the",    "in",   "n",
                                           "anzahl", "der",  "nr",     "each", "profile"};
    std::vector<double> numbers;
    bool count = false;
    double product = 1.0;
    for (const std::string_view token : all) {
        const std::string word = lowerCase(token);
        if (beginsWithDigit(token)) {
            const auto parts = numberAndUnit(token);
            if (!parts || !parts->unit.empty() || parts->number != std::trunc(parts->number)) return false;
            numbers.push_back(parts->number);
            product *= parts->number;
        } else if (std::ranges::find(counted, word) != std::end(counted)) {
            count = true;
        } else if (std::ranges::find(beside, word) == std::end(beside)) {
            return false;
        }
    }
    const bool fits = file.has(product) || std::ranges::all_of(numbers, [&](double n) { return file.has(n); });
    return count && !numbers.empty() && !fits;
}

bool isDoubtful(std::string_view clause, const FileFacts& file)
{
    const std::vector<NameWord> words = wordsWithMeaning(clause);
    const auto has = [&](WordMeaning meaning) {
        return std::ranges::find(words, meaning, &NameWord::meaning) != words.end();
    };
    const auto all = tokens(clause);
    const bool figure = endsWithFigure(all);
    const bool depth = has(WordMeaning::Depth), height = depth || has(WordMeaning::Height);
    const bool subject = height || has(WordMeaning::Data);
    if ((depth || has(WordMeaning::Function)) && !figure) return true;
    if (has(WordMeaning::Scaling)) return true;
    if (!words.empty() && words.front().meaning == WordMeaning::Turns && !has(WordMeaning::X)) return true;
    if (countsOtherwise(all, file)) return true;
    if (has(WordMeaning::Turns) && has(WordMeaning::Quantity) && !figure) return true; // "peaks are negative"
    if (!subject) return false;
    return has(WordMeaning::Turns) || has(WordMeaning::Below) || has(WordMeaning::Factor) ||
           (has(WordMeaning::Quantity) && !figure) || namesOtherUnit(clause, height, file) || holdsFactorSign(clause);
}

/// The parts of a text between commas, semicolons and full stops.
bool holdsDoubt(std::string_view text, const FileFacts& file)
{
    std::size_t begin = 0;
    for (std::size_t at = 0; at <= text.size(); ++at) {
        const bool blank = at + 1 >= text.size() || text[at + 1] == ' ' || text[at + 1] == '\t';
        const bool end = at == text.size() || text[at] == ';' || ((text[at] == ',' || text[at] == '.') && blank);
        if (!end) continue;
        if (isDoubtful(text.substr(begin, at - begin), file)) return true;
        begin = at + 1;
    }
    return false;
}

/// The unit of a length.
std::string unitOfLength(const HeaderValue& value)
{
    const auto parts = numberAndUnit(value.value);
    return parts && !parts->unit.empty() ? parts->unit : value.unit;
}

/// A value that the reader of columns does not use, and that the file contradicts.
bool contradicts(HeaderField field, const HeaderValue& value, const FileFacts& file)
{
    const auto parts = numberAndUnit(value.value);
    const std::string unitText = unitOfLength(value);
    const auto differs = [](double a, double b, double most) { return a > most * b || b > most * a; };
    const MapTable& table = file.table;
    switch (field) {
    case HeaderField::LateralUnit:
    case HeaderField::UnitY: return !spelledLength(value.value) || !file.knows(*spelledLength(value.value));
    case HeaderField::HeightUnit: {
        const double metres = spelledLength(value.value).value_or(0.0);
        return differs(metres, file.units.back(), 1.0 + 1e-9);
    }
    case HeaderField::Scale: return !parts || parts->number != 1.0;
    case HeaderField::PointsX:
    case HeaderField::PointsY: return parts && !file.has(parts->number);
    case HeaderField::StepX:
    case HeaderField::Step: {
        const auto metres = spelledLength(unitText);
        if (file.matrix || table.columns < 2 || table.rows() < 2 || !parts || !metres) return false;
        const double step = std::abs(table.at(1, 0) - table.at(0, 0)) * file.units.front();
        return step > 0.0 && differs(parts->number * *metres, step, 1.02);
    }
    case HeaderField::HeightRange: { // levelled heights have another range, but not by much
        const auto metres = spelledLength(unitText);
        if (!metres || !parts || !(parts->number > 0.0)) return false;
        double low = INFINITY, high = -INFINITY;
        for (std::size_t row = 0; row < table.rows(); ++row)
            for (std::size_t column = file.matrix ? 0 : table.columns - 1; column < table.columns; ++column) {
                low = std::min(low, table.at(row, column));
                high = std::max(high, table.at(row, column));
            }
        return differs((high - low) * file.units.back(), parts->number * *metres, 3.0);
    }
    default: return false;
    }
}

/// "# x recess" above the columns: a place that is known, and another name that is not.
bool mayBeHeading(const HeadingLine& line, const MapTable& table)
{
    if (table.columns < 2 || isValue(line.text)) return false;
    const auto cells = headingCells(line.text, table.separator, table.columns);
    if (!cells) return false;
    const ColumnName first = columnName(cells->front().name);
    return first.known && first.role == ColumnRole::X && !columnName(cells->back().name).known;
}

} // namespace

std::vector<HeadingLine> unusedRemarks(const MapTable& table, const HeaderValues& values, const ColumnUnits& units,
                                       const std::vector<int>& used, bool matrix)
{
    FileFacts file{table, units, matrix};
    for (const auto& [field, value] : values.given()) {
        const bool sides = matrix || table.columns == 1;
        const bool unit = sides && (field == HeaderField::LateralUnit || field == HeaderField::UnitY);
        const auto metres = spelledLength(unit ? value.value : unitOfLength(value));
        if (metres && (unit || field <= HeaderField::Step)) file.others.push_back(*metres);
    }
    std::vector<HeadingLine> doubtful;
    const auto report = [&](const HeadingLine& line) {
        const bool known =
            std::ranges::any_of(doubtful, [&](const HeadingLine& each) { return each.line == line.line; });
        if (!known && doubtful.size() < mostRemarks)
            doubtful.push_back({std::string(trimmed(withoutMark(line.text))), line.line, line.comment});
    };
    std::size_t read = 0;
    const auto judge = [&](const HeadingLine& line, bool nearest) {
        if (line.text.size() > longestHeading || std::ranges::find(used, line.line) != used.end()) return;
        if (++read > mostRemarksRead) return;
        const auto pieces = remarksIn(line.text);
        const auto doubts = [&](std::string_view piece) { return holdsDoubt(withoutMark(piece), file); };
        if (std::ranges::any_of(pieces, doubts) || (nearest && mayBeHeading(line, table))) report(line);
    };
    for (const HeadingLine& line : table.headings) judge(line, &line == &table.headings.back());
    std::vector<HeadingLine> behind;
    for (std::size_t i = 0; i < std::min(table.breaks.size(), mostRemarksRead); ++i)
        behind.push_back(table.breaks[i].line);
    for (const HeadingLine& line : behind) judge(line, false);
    const auto compare = [&](const HeaderValues& given, const std::vector<HeadingLine>& lines) {
        for (const auto& [field, value] : given.given())
            if (contradicts(field, value, file))
                for (const HeadingLine& line : lines)
                    if (line.line == value.line) report(line);
    };
    compare(values, table.headings);
    compare(HeaderValues(behind), behind);
    std::ranges::sort(doubtful, {}, &HeadingLine::line);
    return doubtful;
}

} // namespace touchdown
