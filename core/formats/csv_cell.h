// SPDX-License-Identifier: GPL-3.0-or-later
//
// A field of CSV as RFC 4180 wants it.
#pragma once

#include <string>

namespace touchdown {

/// With a comma, a quotation mark or a line break in it, it stands in quotation marks.
inline std::string csvField(const std::string& text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

} // namespace touchdown
