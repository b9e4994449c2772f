// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/decimal.h"

#include <array>
#include <charconv>
#include <cstdlib>

namespace touchdown {

namespace {

/// "1.25e-07" of to_chars, with the exponent shifted, written as people do.
std::string layOut(std::string_view scientific, int shift)
{
    std::string sign;
    if (scientific.starts_with('-')) {
        sign = "-";
        scientific.remove_prefix(1);
    }
    const auto mark = scientific.find('e');
    std::string_view exponentText = scientific.substr(mark + 1);
    if (exponentText.starts_with('+')) exponentText.remove_prefix(1);
    int exponent = 0;
    std::from_chars(exponentText.data(), exponentText.data() + exponentText.size(), exponent);
    std::string digits;
    for (const char c : scientific.substr(0, mark))
        if (c != '.') digits += c;
    while (digits.size() > 1 && digits.back() == '0') digits.pop_back();
    if (digits == "0") return sign + "0";

    exponent += shift;
    const int count = static_cast<int>(digits.size());
    if (exponent < -4 || exponent > 5) {
        if (count > 1) digits.insert(1, ".");
        return sign + digits + 'e' + std::to_string(exponent);
    }
    if (exponent < 0) return sign + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
    if (count <= exponent + 1) return sign + digits + std::string(static_cast<std::size_t>(exponent + 1 - count), '0');
    digits.insert(static_cast<std::size_t>(exponent + 1), ".");
    return sign + digits;
}

std::string scientific(double value, std::optional<int> digits)
{
    std::array<char, 64> buffer{};
    char* const end = buffer.data() + buffer.size();
    const auto result = digits ? std::to_chars(buffer.data(), end, value, std::chars_format::scientific, *digits - 1)
                               : std::to_chars(buffer.data(), end, value, std::chars_format::scientific);
    return {buffer.data(), result.ptr};
}

} // namespace

std::optional<double> readDecimal(std::string_view number, int decade)
{
    double value = 0.0;
    const auto mark = number.find_first_of("eE");
    int exponent = 0;
    if (mark != std::string_view::npos) {
        std::string_view digits = number.substr(mark + 1);
        if (digits.starts_with('+')) digits.remove_prefix(1);
        if (std::from_chars(digits.data(), digits.data() + digits.size(), exponent).ec != std::errc{})
            return std::nullopt;
        if (std::abs(exponent) > 10000) return std::nullopt;
    }
    const std::string shifted = std::string(number.substr(0, mark)) + 'e' + std::to_string(exponent + decade);
    if (std::from_chars(shifted.data(), shifted.data() + shifted.size(), value).ec != std::errc{}) return std::nullopt;
    return value;
}

std::string decimalText(double value, int decade, std::optional<int> digits)
{
    return layOut(scientific(value, digits), decade);
}

} // namespace touchdown
