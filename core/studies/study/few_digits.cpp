// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/few_digits.h"

#include <cmath>

#include "core/formats/units.h"

namespace touchdown {

double roundedTo(double value, int digits)
{
    if (value == 0.0 || !std::isfinite(value)) return value;
    const int place = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
    // Dividing by a power of ten that is exact keeps the text short where multiplying by its inverse does not.
    const double scale = std::pow(10.0, std::abs(place));
    return place >= 0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
}

std::string fewDigits(double value, const std::string& displayUnit, int digits)
{
    const double factor = displayUnit.empty() || displayUnit == "1" ? 1.0 : unitFactor(displayUnit);
    const std::string number = formatNumber(roundedTo(value / factor, digits));
    return factor == 1.0 && (displayUnit.empty() || displayUnit == "1") ? number : number + ' ' + displayUnit;
}

std::string fewDigitsOfTime(double seconds, int digits)
{
    const char* unit = seconds >= 1.0 ? "s" : seconds >= 1e-3 ? "ms" : seconds >= 1e-6 ? "us" : "ns";
    return fewDigits(seconds, unit, digits);
}

} // namespace touchdown
