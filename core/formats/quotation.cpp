// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/quotation.h"

#include <cstdio>

namespace touchdown {

namespace {

/// The character that begins at the front of the text; length 0 where there is no UTF-8.
struct Utf8Character {
    unsigned code = 0;
    std::size_t length = 0;
};
Utf8Character firstCharacter(std::string_view text)
{
    const auto lead = static_cast<unsigned char>(text.front());
    if (lead < 0x80) return {lead, 1};
    const std::size_t length = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
    if (findInvalidUtf8(text.substr(0, length)) != std::string_view::npos) return {};
    unsigned code = lead & (0xffu >> (length + 1));
    for (const char c : text.substr(1, length - 1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3fu);
    return {code, length};
}

bool isUnprintable(unsigned code)
{
    const bool control = code < 0x20 || (code >= 0x7f && code < 0xa0);
    const bool turnsDirection = code == 0x061c || code == 0x200e || code == 0x200f || // Bidi_Control of Unicode
                                (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
    return control || turnsDirection;
}

} // namespace

std::string printable(std::string_view text, bool severalLines)
{
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const Utf8Character character = firstCharacter(text);
        const std::size_t length = character.length == 0 ? 1 : character.length;
        const bool stays = text.front() == '\t' || (severalLines && text.front() == '\n');
        char escape[8] = "";
        if (character.length == 0)
            std::snprintf(escape, sizeof escape, "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(text[0])));
        else if (isUnprintable(character.code) && !stays)
            std::snprintf(escape, sizeof escape, "\\u%04x", character.code);
        if (escape[0] != '\0')
            shown += escape;
        else
            shown += text.substr(0, length);
        text.remove_prefix(length);
    }
    return shown;
}

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
    while (!text.empty()) {
        const Utf8Character character = valid ? firstCharacter(text) : Utf8Character{};
        const auto byte = static_cast<unsigned char>(text.front());
        const std::size_t length = valid ? character.length : 1;
        if (valid ? isUnprintable(character.code) : byte >= 0x80 || isUnprintable(byte))
            shown += '?';
        else
            shown += text.substr(0, length);
        text.remove_prefix(length);
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
