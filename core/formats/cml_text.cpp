// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/cml_text.h"

#include <algorithm>
#include <cmath>

#include "core/formats/decimal.h"
#include "core/formats/quotation.h"

namespace touchdown {

namespace {

constexpr std::string_view separators = " \t\r\n\v\f,";

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Windows, Unix and lone carriage returns; the count is that of the ends that lie before `end`.
int countLineEnds(std::string_view text, std::size_t begin, std::size_t end)
{
    int count = 0;
    for (std::size_t i = begin; i < end; ++i)
        if (text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'))) ++count;
    return count;
}

} // namespace

std::optional<std::string> plainDecimal(std::string_view text)
{
    // [+-] digits [. digits] [[eEdD] [+-] digits]: the grammar is checked here, as std::from_chars stops at what it
    // does not know and takes "nan".
    std::size_t at = 0;
    const auto sign = [&] { return at < text.size() && (text[at] == '+' || text[at] == '-'); };
    const auto digits = [&] {
        const std::size_t begin = at;
        while (at < text.size() && isDigit(text[at])) ++at;
        return at - begin;
    };
    if (sign()) ++at;
    const std::size_t mantissa = at;
    std::size_t count = digits();
    if (at < text.size() && text[at] == '.') {
        ++at;
        count += digits();
    }
    if (count == 0) return std::nullopt;
    std::string number(text.substr(mantissa, at - mantissa));
    if (at < text.size()) {
        const bool letter = std::string_view("eEdD").find(text[at]) != std::string_view::npos;
        if (letter) ++at;
        if (!letter && !sign()) return std::nullopt;
        const std::size_t exponent = at;
        if (sign()) ++at;
        if (digits() == 0 || at != text.size()) return std::nullopt;
        number += 'e' + std::string(text.substr(exponent));
    }
    if (text.front() == '-') number.insert(0, "-");
    return number;
}

std::optional<double> readCmlNumber(std::string_view text)
{
    const auto decimal = plainDecimal(text);
    return decimal ? readDecimal(*decimal) : std::nullopt;
}

int wholeCmlNumber(const CmlNumber& number, std::string_view what, int lowest, int highest)
{
    if (number.value == std::trunc(number.value) && number.value >= lowest && number.value <= highest)
        return static_cast<int>(number.value);
    throw CmlError(number.line, std::string(what) + " must be a whole number from " + std::to_string(lowest) + " to " +
                                    std::to_string(highest) + ", not " + inQuotes(number.text));
}

CmlText::CmlText(std::string_view text, int line) : text_(text), line_(line)
{
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    if (const auto end = text_.find('\x1a'); end != std::string_view::npos) text_ = text_.substr(0, end); // of DOS
    const auto noText = std::ranges::find_if(text_, [](char c) {
        return static_cast<unsigned char>(c) < 0x20 && separators.find(c) == std::string_view::npos;
    });
    if (noText == text_.end()) return;
    const auto where = static_cast<std::size_t>(noText - text_.begin());
    throw CmlError(line_ + countLineEnds(text_, 0, where), "holds bytes that no text holds; it may be a binary file");
}

std::string_view CmlText::takeLine()
{
    const std::size_t begin = at_;
    const std::size_t end = std::min(text_.find_first_of("\r\n", begin), text_.size());
    const bool pair = text_.substr(end).starts_with("\r\n");
    moveTo(std::min(end + (pair ? 2 : 1), text_.size()));
    return text_.substr(begin, end - begin);
}

std::string_view CmlText::peekWord()
{
    const std::size_t begin = wordBegin();
    return text_.substr(begin, wordEnd(begin) - begin);
}

std::string_view CmlText::takeWord()
{
    const std::string_view word = peekWord();
    skipBlanks();
    moveTo(at_ + word.size());
    return word;
}

bool CmlText::onThisLine()
{
    const std::size_t begin = wordBegin();
    return begin < text_.size() && countLineEnds(text_, at_, begin) == 0;
}

bool CmlText::nextIsNumber() { return readCmlNumber(peekWord()).has_value(); }

CmlNumber CmlText::number(std::string_view what)
{
    moveTo(wordBegin());
    const std::string_view word = peekWord();
    if (word.empty()) throw CmlError(lastLine(), "the file ends where " + std::string(what) + " is needed");
    const auto value = readCmlNumber(word);
    if (!value) throw CmlError(line_, std::string(what) + " must be a number, not " + inQuotes(word));
    const int line = line_;
    return {*value, takeWord(), line};
}

int CmlText::whole(std::string_view what, int lowest, int highest)
{
    return wholeCmlNumber(number(what), what, lowest, highest);
}

void CmlText::skipRemark()
{
    if (onThisLine() && !nextIsNumber()) takeLine();
}

bool CmlText::endList()
{
    const bool more = onThisLine() && nextIsNumber();
    takeLine();
    return more;
}

int CmlText::lastLine() const
{
    const std::size_t end = text_.find_last_not_of(separators) + 1; // 0 if there is none
    return end < at_ ? line_ - countLineEnds(text_, end, at_) : line_ + countLineEnds(text_, at_, end);
}

std::size_t CmlText::wordBegin() const { return std::min(text_.find_first_not_of(separators, at_), text_.size()); }

std::size_t CmlText::wordEnd(std::size_t begin) const
{
    return std::min(text_.find_first_of(separators, begin), text_.size());
}

void CmlText::moveTo(std::size_t at)
{
    line_ += countLineEnds(text_, at_, at);
    at_ = at;
}

} // namespace touchdown
