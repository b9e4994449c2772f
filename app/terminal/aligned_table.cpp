// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/aligned_table.h"

#include <algorithm>

namespace touchdown {

std::size_t textWidth(const std::string& text)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; }));
}

std::string alignedTable(const std::vector<std::vector<std::string>>& rows, const std::vector<bool>& left)
{
    std::vector<std::size_t> widths;
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i == widths.size()) widths.push_back(0);
            widths[i] = std::max(widths[i], textWidth(row[i]));
        }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string space(widths[i] - textWidth(row[i]), ' ');
            line += i == 0 ? "" : "  ";
            line += i < left.size() && left[i] ? row[i] + space : space + row[i];
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

} // namespace touchdown
