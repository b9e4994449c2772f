// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/text_encoding.h"

#include <cstddef>
#include <string_view>
#include <utility>

namespace touchdown {

namespace {

constexpr char32_t replacement = 0xFFFD; // of a surrogate without its pair

void appendUtf8(std::string& text, char32_t code)
{
    const auto put = [&](char32_t byte) { text += static_cast<char>(byte); };
    const auto tail = [&](int shift) { put(0x80 | ((code >> shift) & 0x3F)); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0 | (code >> 6));
        tail(0);
    } else if (code < 0x10000) {
        put(0xE0 | (code >> 12));
        tail(6);
        tail(0);
    } else {
        put(0xF0 | (code >> 18));
        tail(12);
        tail(6);
        tail(0);
    }
}

std::string fromUtf16(std::string_view bytes, bool bigEndian)
{
    const auto unit = [&](std::size_t at) {
        const auto first = static_cast<unsigned char>(bytes[at]), second = static_cast<unsigned char>(bytes[at + 1]);
        return static_cast<char32_t>(bigEndian ? first << 8 | second : second << 8 | first);
    };
    std::string text;
    text.reserve(bytes.size() / 2);
    for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
        char32_t code = unit(at);
        if (code >= 0xD800 && code < 0xE000) {
            const char32_t low = code < 0xDC00 && at + 3 < bytes.size() ? unit(at + 2) : 0;
            const bool pair = low >= 0xDC00 && low < 0xE000;
            code = pair ? 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00) : replacement;
            if (pair) at += 2;
        }
        appendUtf8(text, code);
    }
    return text;
}

} // namespace

std::string asUtf8(std::string text)
{
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    const bool littleEndian = text.starts_with("\xFF\xFE"), bigEndian = text.starts_with("\xFE\xFF");
    if (!littleEndian && !bigEndian) return text;
    return fromUtf16(std::string_view(text).substr(2), bigEndian);
}

} // namespace touchdown
