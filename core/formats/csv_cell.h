// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells of a CSV table (RFC 4180).
#pragma once

#include <string>
#include <string_view>
#include <vector>

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

/// The cells of each line; a quotation mark that is never closed ends with the text.
inline std::vector<std::vector<std::string>> csvRows(std::string_view text)
{
    std::vector<std::vector<std::string>> rows;
    bool quoted = false, isNew = true;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (isNew) rows.push_back({""});
        isNew = false;
        std::string& cell = rows.back().back();
        if (quoted && c == '"' && text.substr(i + 1).starts_with('"'))
            cell += text[++i];
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted && c == ',')
            rows.back().emplace_back();
        else if (!quoted && c == '\n')
            isNew = true;
        else if (quoted || c != '\r')
            cell += c;
    }
    return rows;
}

} // namespace touchdown
