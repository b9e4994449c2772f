// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/toml_quantity.h"

#include <cmath>

namespace touchdown {

std::variant<double, UnitProblem> tomlQuantity(const TomlValue& value, std::string_view unit,
                                               std::string_view displayUnit)
{
    double number = 0.0;
    if (const auto* text = std::get_if<std::string>(&value)) return parseQuantity(*text, unit);
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        number = static_cast<double>(*whole);
    else if (const auto* real = std::get_if<double>(&value))
        number = *real;
    else
        return UnitProblem{"has the wrong type; a number" +
                           (displayUnit.empty() ? std::string() : " or \"1 " + std::string(displayUnit) + "\"") +
                           " is needed"};
    if (!std::isfinite(number)) return UnitProblem{"is not a finite number"};
    return number + 0.0; // -0 is 0, which has one spelling
}

std::string formatTomlQuantity(double value, std::string_view displayUnit)
{
    const std::string text = formatQuantity(value, displayUnit);
    return text.find(' ') == std::string::npos ? text : tomlString(text);
}

} // namespace touchdown
