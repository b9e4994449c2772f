// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/surface_units.h"

#include <algorithm>
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
constexpr Spelling words[] = {{"metre", 1.0},        {"centimetre", 1e-2}, {"millimetre", 1e-3}, {"micrometre", 1e-6},
                              {"mikrometre", 1e-6},  {"nanometre", 1e-9},  {"picometre", 1e-12}, {"micron", 1e-6},
                              {"angstrom", 1e-10},   {"angstroem", 1e-10}, {"inch", 0.0254},     {"inche", 0.0254},
                              {"microinch", 25.4e-9}};

/// Units in parentheses or without brackets that are no length.
constexpr std::string_view otherUnits[] = {
    "s",   "ms",  "us",   "ns",   "min",  "h",   "V",    "mV",    "uV",     "kV",      "mA",     "uA",      "nA",
    "pA",  "deg", "rad",  "mrad", "urad", "px",  "pix",  "pixel", "pixels", "count",   "counts", "cts",     "lsb",
    "LSB", "bit", "bits", "a.u.", "au",   "arb", "%",    "Hz",    "kHz",    "MHz",     "N",      "mN",      "uN",
    "nN",  "Pa",  "kPa",  "MPa",  "GPa",  "K",   "volt", "volts", "degree", "degrees", "sec",    "seconds", "M",
    "MM",  "Mm",  "mM",   "uM",   "nM",   "Nm",  "pM",   "PM",    "CM",     "KM",      "Um",     "nm/s"};

constexpr std::pair<std::string_view, std::string_view> plainLetters[] = {
    {"\xC2\xB5", "u"},      {"\xCE\xBC", "u"},      {"&micro;", "u"},  {"&mu;", "u"},
    {"\\mu ", "u"},         {"\\mu", "u"},          {"$", ""},         {"\xE3\x8E\x9B", "um"},
    {"\xE3\x8E\x9A", "nm"}, {"\xE3\x8E\x9C", "mm"}, {"\xC3\x85", "A"}, {"\xE2\x84\xAB", "A"},
    {"A\xCC\x8A", "A"},     {"&Aring;", "A"},       {"\xC3\xA5", "a"}, {"\xC3\xB6", "o"},
    {"o\xCC\x88", "o"},     {"\xC2\xA0", " "}};
constexpr std::pair<std::string_view, std::string_view> plainLatin1[] = {
    {"\xB5", "u"}, {"\xC5", "A"}, {"\xE5", "a"}, {"\xF6", "o"}, {"\xA0", " "}};

void replaceAll(std::string& text, std::string_view from, std::string_view to)
{
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// Micro signs to u, letters with rings and dots to plain ones.
std::string plain(std::string_view line)
{
    std::string text(line);
    if (findInvalidUtf8(text) == std::string_view::npos)
        for (const auto& [from, to] : plainLetters) replaceAll(text, from, to);
    else
        for (const auto& [from, to] : plainLatin1) replaceAll(text, from, to);
    return text;
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

bool isOtherUnit(std::string_view word) { return std::ranges::find(otherUnits, word) != std::end(otherUnits); }

char closing(char open)
{
    switch (open) {
    case '(': return ')';
    case '[': return ']';
    case '{': return '}';
    default: return '>';
    }
}

bool isNumberLetter(char c) { return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.'; }

/// Reads a heading from left to right.
class Mentions {
public:
    explicit Mentions(std::string_view line) : line_(line) {}

    std::vector<UnitMention> read()
    {
        while (at_ < line_.size()) {
            const char c = line_[at_];
            if (std::string_view("([{<").find(c) != std::string_view::npos)
                bracket();
            else if (separators.find(c) != std::string_view::npos)
                separator(c);
            else
                word(line_.substr(at_, line_.find_first_of(ends, at_) - at_));
        }
        return std::move(mentions_);
    }

private:
    static constexpr std::string_view separators = " \t,;:=/|\"')]}>";
    static constexpr std::string_view ends = " \t,;:=/|\"'()[]{}<>";
    enum class Before { Start, Word, Unit, Times, Number, Value, Slash, In }; // Value: a number's unit

    void add(std::string_view text, std::optional<double> metres) { mentions_.push_back({std::string(text), metres}); }

    void separator(char c)
    {
        ++at_;
        if (c == '/') before_ = before_ == Before::Value ? Before::Number : Before::Slash; // "5 um/s"
        if (c == ',' || c == ';' || c == '\t' || c == '|') before_ = Before::Start;
    }

    void bracket()
    {
        const char open = line_[at_];
        const std::size_t close = std::min(line_.find(closing(open), at_), line_.size());
        const bool isValue = std::exchange(before_, Before::Word) == Before::Number;
        std::string_view content = trimmed(line_.substr(at_ + 1, close - at_ - 1), " \t\"'");
        at_ = std::min(close + 1, line_.size());
        if (content.starts_with("in ")) content = trimmed(content.substr(3));
        if (content.empty()) return;
        const std::size_t count = mentions_.size();
        std::vector<UnitMention> list; // "[um, nm]"
        for (std::size_t begin = 0; begin <= content.size();) {
            const std::size_t end = std::min(content.find_first_of(",;", begin), content.size());
            const std::string_view part = trimmed(content.substr(begin, end - begin));
            list.push_back({std::string(part), plainLength(part)});
            begin = end + 1;
        }
        const bool lengths = std::ranges::all_of(list, [](const UnitMention& m) { return m.metres.has_value(); });
        if (isValue && (lengths || open != '(' || isOtherUnit(content))) return; // "16 [um]"
        if (lengths)
            mentions_.insert(mentions_.end(), list.begin(), list.end());
        else if (open != '(' || isOtherUnit(content))
            add(content, std::nullopt);
        else if (content.find_first_of("0123456789") == std::string_view::npos) // "(x in um, h in nm)"
            for (const UnitMention& mention : Mentions(content).read()) add(mention.text, mention.metres);
        if (mentions_.size() > count) before_ = Before::Unit;
    }

    void word(std::string_view text)
    {
        at_ += text.size();
        const Before before = std::exchange(before_, Before::Word);
        const bool glued = text.size() > 1 && isNumberLetter(text[0]) && isNumberLetter(text[1]); // "-1um", ".5"
        const bool afterUnit = before == Before::Unit || before == Before::Times;
        if ((text[0] >= '0' && text[0] <= '9') || glued) {
            if (afterUnit) spoil(text); // "[nm] x 10"
            before_ = Before::Number;
            return;
        }
        if (before == Before::Unit && isFactor(text)) {
            if (text.back() == '0') spoil(text); // "[nm] x10"
            before_ = Before::Times;
            return;
        }
        if (lowerCase(text) == "in") {
            before_ = Before::In;
            return;
        }
        if (before == Before::Number) {
            before_ = Before::Value;
            return;
        }
        const bool named = before == Before::Slash || before == Before::In; // "x/um", "x in um"
        const std::string_view last = std::exchange(last_, text);
        if (text.starts_with("m") && before == Before::Word && plainLength(text) && isPrefix(last)) { // "micro m"
            add(std::string(last) + ' ' + std::string(text), std::nullopt);
            return;
        }
        if (const auto metres = plainLength(text)) {
            // "A" alone is also a name: "Disk A".
            if (text != "A" || named || !mentions_.empty() || (before == Before::Start && endsCell()))
                add(text, metres), before_ = Before::Unit;
            return;
        }
        if (isOtherUnit(text)) {
            if (named || text.size() > 1) add(text, std::nullopt); // "h" and "s" are names, too
            return;
        }
        suffix(text);
    }

    /// "x_um", "x-um", "x..um."
    void suffix(std::string_view text)
    {
        text = text.substr(0, text.find_last_not_of("._") + 1);
        const std::size_t mark = text.find_last_of("._-");
        if (mark == std::string_view::npos || mark == 0) return;
        const std::string_view unit = text.substr(mark + 1);
        const auto metres = plainLength(unit);
        if (unit == "in" || (!metres && !isOtherUnit(unit))) return;
        add(unit, metres);
        before_ = Before::Unit;
    }

    /// Also "E-6", a factor.
    static bool isPrefix(std::string_view word)
    {
        constexpr std::string_view prefixes[] = {"u", "n", "p", "c", "micro", "mikro", "nano", "pico", "milli", "mu"};
        const std::string lower = lowerCase(word);
        return std::ranges::find(prefixes, lower) != std::end(prefixes) || lower.starts_with("e-") || word == "m";
    }

    static bool isFactor(std::string_view text)
    {
        for (const std::string_view times : {"*", "x", "X", "\xC3\x97"})
            if (text == times || (text.starts_with(times) && text.substr(times.size()).starts_with("10"))) return true;
        return text.starts_with('*');
    }
    void spoil(std::string_view factor)
    {
        mentions_.back().text.append(" ").append(factor);
        mentions_.back().metres = std::nullopt;
    }

    bool endsCell() const
    {
        const std::size_t next = line_.find_first_not_of(" \"'", at_);
        return next == std::string_view::npos || std::string_view(",;\t|").find(line_[next]) != std::string_view::npos;
    }

    std::string_view line_;
    std::size_t at_ = 0;
    Before before_ = Before::Start;
    std::string_view last_; // word
    std::vector<UnitMention> mentions_;
};

} // namespace

std::optional<double> spelledLength(std::string_view unit) { return plainLength(plain(unit)); }

std::optional<NumberAndUnit> numberAndUnit(std::string_view quantity)
{
    const std::string text = plain(trimmed(quantity, " \t\"'"));
    if (mayCountThousands(std::string_view(text).substr(0, text.find_first_not_of("+-0123456789,")))) return {};
    for (std::size_t end = text.size(); end > 0; --end) {
        std::string number = text.substr(0, end);
        if (const auto comma = number.find(','); comma != std::string::npos) number[comma] = '.';
        if (const auto value = readCmlNumber(number))
            return NumberAndUnit{*value, std::string(trimmed(std::string_view(text).substr(end), " \t[](){}<>\"'"))};
    }
    return std::nullopt;
}

std::vector<UnitMention> unitMentions(std::string_view line)
{
    const std::string text = plain(line);
    return Mentions(text).read();
}

} // namespace touchdown
