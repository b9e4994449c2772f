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

struct TomlElement;
struct TomlArray {
    std::vector<TomlElement> elements;
};

/// What a case file may hold; std::monostate for all else (dates, tables among the values of an array).
using TomlValue = std::variant<std::monostate, bool, std::int64_t, double, std::string, TomlArray>;

struct TomlElement {
    TomlValue value;
    int line = 0;
};

struct TomlEntry {
    std::string key; // "springs.cutoff", "abs.rail[1].recess"; a part that is no bare key stands in quotation marks
    TomlValue value;
    int line = 0;
    std::size_t begin = 0; // of the value's text, quotation marks included [byte]
    std::size_t end = 0;   // one past it
};

enum class TomlTableKind : std::uint8_t {
    Header,  // [a], or one table a[1] of [[a]]
    Inline,  // a = {}
    Dotted,  // a.b = 1
    Implied, // the a of [a.b]
    Array,   // all of [[a]], or a = [{}, {}]; the tables a[1], a[2] follow, counted from 1
};

struct TomlTable {
    std::string key;
    TomlTableKind kind = TomlTableKind::Dotted;
    int line = 0;
    std::size_t begin = 0; // of the header, the inline table or the array; of the first header of [[a]] [byte]
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
