// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/surface_fields.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "core/formats/cml_text.h"
#include "core/formats/quotation.h"
#include "core/formats/surfaces/surface_units.h"
#include "core/formats/words.h"
#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

namespace {

constexpr std::string_view simpleField = "Gwyddion Simple Field 1.0";

/// The number of a line "name = 5".
std::optional<double> numberOf(const MapTable& table, std::string_view wanted)
{
    for (const HeadingLine& line : table.headings) {
        const std::string_view text = line.text;
        const auto sign = text.find('=');
        if (sign == std::string_view::npos || lowerCase(trimmed(text.substr(0, sign))) != wanted) continue;
        const auto parts = numberAndUnit(text.substr(sign + 1));
        return parts ? std::optional(parts->number) : std::nullopt;
    }
    return std::nullopt;
}

std::size_t countOf(const MapTable& table, const char* name)
{
    const double count = numberOf(table, lowerCase(name)).value_or(0.0);
    if (!(count >= 1.0 && count <= mostMapPoints && count == std::trunc(count)))
        throw CmlError(0, std::string(name) + " must be the number of points, at most 64 million");
    return static_cast<std::size_t>(count);
}

/// Takes the lines of a header, up to the one that is `end` or to a zero byte.
void takeHeader(CmlText& reader, std::string_view end, MapTable& table)
{
    while (!reader.atEnd()) {
        const int number = reader.line();
        const std::string_view line = trimmed(reader.takeLine());
        if (line == end) return;
        table.headings.push_back({std::string(line), number, false});
    }
}

void setSize(MapTable& table, std::size_t columns, std::size_t rows)
{
    if (static_cast<double>(columns) * static_cast<double>(rows) > mostMapPoints)
        throw CmlError(0, "there are too many points; at most 64 million can be read");
    table.columns = columns;
    table.lines.assign(rows, 0);
    table.numbers.reserve(columns * rows);
}

} // namespace

bool isSimpleField(std::string_view bytes) { return bytes.starts_with(simpleField); }

bool isSdf(std::string_view text) { return text.starts_with("aBCR-") || text.starts_with("aISO-"); }

MapTable readSimpleField(std::string_view bytes)
{
    MapTable table;
    const std::size_t end = bytes.find('\0');
    if (end == std::string_view::npos) throw CmlError(0, "is cut off: a simple field has a zero byte after its lines");
    CmlText reader(bytes.substr(0, end));
    takeHeader(reader, "\n", table);
    const std::size_t columns = countOf(table, "XRes"), rows = countOf(table, "YRes");
    const std::size_t begin = (end / 4 + 1) * 4;
    setSize(table, columns, rows);
    if (bytes.size() != begin + 4 * columns * rows)
        throw CmlError(0, "has " + std::to_string(bytes.size() - std::min(begin, bytes.size())) +
                              " bytes of heights; " + std::to_string(columns) + " x " + std::to_string(rows) +
                              " points need " + std::to_string(4 * columns * rows));
    for (std::size_t at = begin; at < bytes.size(); at += 4) {
        std::uint32_t bits = 0;
        for (std::size_t k = 4; k-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes[at + k]);
        const double height = std::bit_cast<float>(bits);
        if (!std::isfinite(height))
            throw CmlError(0,
                           "a surface has no holes: number " + std::to_string((at - begin) / 4 + 1) + " is not finite");
        table.numbers.push_back(height);
    }
    return table;
}

MapTable readSdf(std::string_view text)
{
    MapTable table;
    CmlText reader(text);
    takeHeader(reader, "*", table);
    const std::size_t columns = countOf(table, "NumPoints"), rows = countOf(table, "NumProfiles");
    const auto scale = numberOf(table, "zscale");
    if (!scale || !(*scale > 0.0)) throw CmlError(0, "Zscale must be the height of one step in m, above 0");
    std::erase_if(table.headings, [](const HeadingLine& line) { return lowerCase(line.text).starts_with("zscale"); });
    table.headings.push_back({"xy unit: m, z unit: m", 0, false});
    setSize(table, columns, rows);
    while (table.numbers.size() < columns * rows) {
        const std::string_view word = reader.peekWord();
        const int line = reader.line();
        if (word == "*" || word.empty())
            throw CmlError(line, "has " + std::to_string(table.numbers.size()) + " heights; " +
                                     std::to_string(columns) + " x " + std::to_string(rows) + " are needed");
        const auto value = readCmlNumber(word);
        if (!value)
            throw CmlError(reader.line(),
                           "a surface has no holes: every height must be a number, not " + inQuotes(word));
        if (table.numbers.size() % columns == 0) table.lines[table.numbers.size() / columns] = reader.line();
        table.numbers.push_back(*value * *scale);
        reader.takeWord();
    }
    if (const std::string_view word = reader.peekWord(); !word.empty() && word != "*")
        throw CmlError(reader.line(),
                       "has more heights than " + std::to_string(columns) + " x " + std::to_string(rows));
    return table;
}

} // namespace touchdown
