// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/number_text.h"

#include <cstdio>

#include "core/formats/units.h"

namespace touchdown {

std::string displayed(double value, const std::string& displayUnit, int digits)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, displayUnit.empty() ? value : value / unitFactor(displayUnit));
    return displayUnit.empty() ? text : std::string(text) + " " + displayUnit;
}

} // namespace touchdown
