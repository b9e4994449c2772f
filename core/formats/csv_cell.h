// SPDX-License-Identifier: GPL-3.0-or-later
//
// A cell of a CSV table (RFC 4180).
#pragma once

#include <string>

namespace touchdown {

/// The text, in quotation marks if it contains a comma, a quotation mark or a line break.
inline std::string csvCell(const std::string& text)
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
