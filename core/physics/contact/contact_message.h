// SPDX-License-Identifier: GPL-3.0-or-later
//
// Messages of the contact solvers.
#pragma once

#include <cstdio>
#include <string>

namespace touchdown {

/// A sentence by a format of printf; at most 255 characters.
template <typename... Values>
std::string sentence(const char* format, Values... values)
{
    char text[256];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

/// Of a periodic contact without a hardness whose surfaces overlap by `depth` in the mean [m].
inline std::string overlapMessage(double depth)
{
    return sentence("The surfaces overlap by %.3g m in the mean, and the mean pressure of a periodic half-space "
                    "displaces nothing: give a greater separation.",
                    depth);
}

} // namespace touchdown
