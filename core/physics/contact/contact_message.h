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

} // namespace touchdown
