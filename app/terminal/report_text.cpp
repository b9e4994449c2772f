// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/report_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/formats/units.h"

namespace touchdown {

namespace {

/// printf with the number of digits or the width as `parameter`.
std::string printed(const char* format, int parameter, double value)
{
    char text[64];
    std::snprintf(text, sizeof text, format, parameter, value);
    return text;
}

double inUnit(double value, const std::string& unit) { return unit.empty() ? value : value / unitFactor(unit); }

std::string withUnit(const std::string& number, const std::string& unit)
{
    return unit.empty() ? number : number + ' ' + unit;
}

} // namespace

std::string displayed(double value, const std::string& displayUnit, int digits)
{
    return withUnit(printed("%.*g", digits, inUnit(value, displayUnit)), displayUnit);
}

std::string displayedInFull(double value, const std::string& displayUnit, int digits)
{
    if (!std::isfinite(value)) return "-";
    std::string number = printed("%#.*g", digits, inUnit(value, displayUnit));
    if (number.ends_with('.')) number.pop_back();
    return withUnit(number, displayUnit);
}

std::string numberColumn(double value, int digits) { return printed("%14.*g", digits, value); }

std::string statusText(std::string_view status, const std::string& message)
{
    if (message.starts_with(status)) return message;
    return std::string(status) + (message.empty() ? "" : ": " + message);
}

std::string reportRow(const std::string& name, const std::string& value)
{
    constexpr std::size_t width = 22;
    return name + std::string(width - std::min(width - 1, name.size()), ' ') + value + "\n";
}

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width)
{
    std::string result;
    std::size_t column = width; // so that the first word begins a line
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::size_t length = end - at;
        if (column + 1 + length > width) {
            result += (result.empty() ? "" : "\n") + std::string(indent, ' ');
            column = indent;
        } else {
            result += ' ';
            ++column;
        }
        result.append(text, at, length);
        column += length;
        at = end + 1;
    }
    return result + "\n";
}

std::string padded(const std::string& text, std::size_t width)
{
    return text + std::string(text.size() < width ? width - text.size() : 0, ' ') + "  ";
}

} // namespace touchdown
