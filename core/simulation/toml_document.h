// SPDX-License-Identifier: GPL-3.0-or-later
//
// A TOML text as a flat list of keys, each with its value and its place in the text, so that a value can be replaced
// without touching the comments and the order around it. toml++ does the parsing.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace touchdown {

/// What a case file may hold; std::monostate for all else (arrays, dates).
using TomlValue = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

struct TomlEntry {
    std::string key; // "springs.cutoff"; a part that is no bare key stands in quotation marks
    TomlValue value;
    int line = 0;
    std::size_t begin = 0; // of the value's text, quotation marks included [byte]
    std::size_t end = 0;   // one past it
};

enum class TomlTableKind : std::uint8_t { Header, Inline, Dotted }; // [a], a = {}, a.b = 1 (or the a of [a.b])

struct TomlTable {
    std::string key;
    TomlTableKind kind = TomlTableKind::Dotted;
    int line = 0;
    std::size_t begin = 0; // of the header or the inline table [byte]
    std::size_t end = 0;
};

struct TomlDocument {
    std::vector<TomlEntry> entries; // in the order of the text
    std::vector<TomlTable> tables;
    std::string problem; // "" when the text is TOML; else what is wrong, and nothing else is set
    int problemLine = 0;
};

/// Refuses at once what is no text: zero bytes, invalid UTF-8, endless lines.
TomlDocument readToml(std::string_view text);

/// A TOML basic string with its quotation marks.
std::string tomlString(std::string_view text);

} // namespace touchdown
