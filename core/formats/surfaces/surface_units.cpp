// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/surface_units.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/formats/cml_text.h"
#include "core/formats/quotation.h"
#include "core/formats/surfaces/map_table.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

struct Spelling {
    std::string_view text;
    double metres;
};

constexpr Spelling symbols[] = {{"m", 1.0},   {"cm", 1e-2},   {"mm", 1e-3},    {"um", 1e-6},
                                {"UM", 1e-6}, {"nm", 1e-9},   {"NM", 1e-9},    {"pm", 1e-12},
                                {"A", 1e-10}, {"in", 0.0254}, {"uin", 25.4e-9}};

/// In lower case, without a plural s.
constexpr Spelling words[] = {{"metre", 1.0},       {"centimetre", 1e-2},       {"millimetre", 1e-3},
                              {"micrometre", 1e-6}, {"mikrometre", 1e-6},       {"nanometre", 1e-9},
                              {"picometre", 1e-12}, {"micron", 1e-6},           {"angstrom", 1e-10},
                              {"angstroem", 1e-10}, {"angstr\xC3\xB6m", 1e-10}, {"inch", 0.0254},
                              {"inche", 0.0254},    {"microinch", 25.4e-9},     {"microinche", 25.4e-9}};

constexpr std::string_view otherUnits[] = {
    "s",   "ms",  "us",   "ns",   "min",  "h",   "V",    "mV",    "uV",     "kV",      "mA",     "uA",      "nA",
    "pA",  "deg", "rad",  "mrad", "urad", "px",  "pix",  "pixel", "pixels", "count",   "counts", "cts",     "lsb",
    "LSB", "bit", "bits", "a.u.", "au",   "arb", "%",    "Hz",    "kHz",    "MHz",     "N",      "mN",      "uN",
    "nN",  "Pa",  "kPa",  "MPa",  "GPa",  "K",   "volt", "volts", "degree", "degrees", "sec",    "seconds", "M",
    "MM",  "Mm",  "mM",   "uM",   "nM",   "Nm",  "pM",   "PM",    "CM",     "KM",      "Um",     "nm/s"};

constexpr std::pair<std::string_view, std::string_view> plainLetters[] = {{"\xC2\xB5", "u"},
                                                                          {"\xCE\xBC", "u"},
                                                                          {"&micro;", "u"},
                                                                          {"&mu;", "u"},
                                                                          {"\\textmu ", "u"},
                                                                          {"\\textmu", "u"},
                                                                          {"\\mu ", "u"},
                                                                          {"\\mu", "u"},
                                                                          {"$", ""},
                                                                          {"\xE3\x8E\x9B", "um"},
                                                                          {"\xE3\x8E\x9A", "nm"},
                                                                          {"\xE3\x8E\x9C", "mm"},
                                                                          {"\xC3\x85ngstr", "angstr"},
                                                                          {"A\xCC\x8A"
                                                                           "ngstr",
                                                                           "angstr"},
                                                                          {"\xC3\x85", "angstrom"},
                                                                          {"\xE2\x84\xAB", "angstrom"},
                                                                          {"A\xCC\x8A", "angstrom"},
                                                                          {"&Aring;", "angstrom"},
                                                                          {"\xC3\xA5", "a"},
                                                                          {"o\xCC\x88", "\xC3\xB6"},
                                                                          {"\xC2\xA0", " "}};
constexpr std::pair<std::string_view, std::string_view> plainLatin1[] = {
    {"\xB5", "u"}, {"\xC5ngstr", "angstr"}, {"\xC5", "angstrom"}, {"\xE5", "a"}, {"\xF6", "\xC3\xB6"}, {"\xA0", " "}};

void replaceAll(std::string& text, std::string_view from, std::string_view to)
{
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

std::optional<double> plainLength(std::string_view unit)
{
    unit = trimmed(unit, " \t\"'.");
    if (const auto found = std::ranges::find(symbols, unit, &Spelling::text); found != std::end(symbols))
        return found->metres;
    std::string word = lowerCase(unit);
    if (word.ends_with('s')) word.pop_back();
    if (word.ends_with("meter")) word.replace(word.size() - 2, 2, "re");
    const auto found = std::ranges::find(words, word, &Spelling::text);
    return found == std::end(words) ? std::nullopt : std::optional(found->metres);
}

} // namespace

std::optional<double> spelledLength(std::string_view unit) { return plainLength(withPlainLetters(unit)); }

bool spellsOtherUnit(std::string_view word) { return std::ranges::find(otherUnits, word) != std::end(otherUnits); }

std::string lengthSymbol(double metres)
{
    const auto same = [=](const Spelling& each) { return std::abs(each.metres - metres) <= 1e-9 * metres; };
    const auto found = std::ranges::find_if(symbols, same);
    return std::string(found == std::end(symbols) ? symbols[0].text : found->text);
}

std::optional<NumberAndUnit> numberAndUnit(std::string_view quantity)
{
    const std::string text = withPlainLetters(trimmed(quantity, " \t\"'"));
    if (mayCountThousands(std::string_view(text).substr(0, text.find_first_not_of("+-0123456789,")))) return {};
    for (std::size_t end = text.size(); end > 0; --end) {
        std::string number = text.substr(0, end);
        if (const auto comma = number.find(','); comma != std::string::npos) number[comma] = '.';
        if (const auto value = readCmlNumber(number))
            return NumberAndUnit{*value, std::string(trimmed(std::string_view(text).substr(end), " \t[](){}<>\"'"))};
    }
    return std::nullopt;
}

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

std::string withPlainLetters(std::string_view line)
{
    std::string text(line);
    if (findInvalidUtf8(text) == std::string_view::npos)
        for (const auto& [from, to] : plainLetters) replaceAll(text, from, to);
    else
        for (const auto& [from, to] : plainLatin1) replaceAll(text, from, to);
    return text;
}

} // namespace touchdown
