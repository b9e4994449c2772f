// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/quotation.h"

namespace touchdown {

std::string inQuotes(std::string_view text)
{
    constexpr std::size_t longest = 60; // [byte]
    const bool cut = text.size() > longest;
    if (cut) {
        text = text.substr(0, longest);
        // Never end inside a character.
        if (const auto bad = findInvalidUtf8(text); bad != std::string_view::npos && bad + 4 > longest)
            text = text.substr(0, bad);
    }
    std::string shown = "\"";
    const bool valid = findInvalidUtf8(text) == std::string_view::npos;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        shown += byte < 0x20 || byte == 0x7f || (byte >= 0x80 && !valid) ? '?' : c;
    }
    return shown + (cut ? "...\"" : "\"");
}

std::string_view withoutQuotes(std::string_view text)
{
    const bool quoted = text.size() > 1 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
    return quoted ? text.substr(1, text.size() - 2) : text;
}

std::size_t findInvalidUtf8(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    for (std::size_t i = 0; i < text.size();) {
        const unsigned lead = byte(i);
        std::size_t length = 1;
        if (lead >= 0x80) {
            if (lead < 0xc2 || lead > 0xf4) return i;
            length = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
            for (std::size_t k = 1; k < length; ++k)
                if ((byte(i + k) & 0xc0u) != 0x80u) return i;
            // Overlong forms, surrogates, and code points beyond U+10FFFF.
            const unsigned second = byte(i + 1);
            if ((lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) || (lead == 0xf0 && second < 0x90) ||
                (lead == 0xf4 && second > 0x8f))
                return i;
        }
        i += length;
    }
    return std::string_view::npos;
}

} // namespace touchdown
