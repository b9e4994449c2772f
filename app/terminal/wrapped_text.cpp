// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/wrapped_text.h"

#include <algorithm>

namespace touchdown {

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
