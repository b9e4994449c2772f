// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/toml_document.h"

#include "core/formats/quotation.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cstdio>

namespace touchdown {

namespace {

// toml++ descends once per dot of a dotted key, so an endless line of dots would end the program.
constexpr std::size_t longestLine = 10000; // [byte]
// Case files have two levels. What lies deeper is not looked into: the keys would take memory by the square of their
// depth.
constexpr int deepest = 8;

/// Byte offsets of the places that toml++ counts in lines and code points, both from 1.
class Places {
public:
    explicit Places(std::string_view text) : text_(text)
    {
        starts_.push_back(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
        for (std::size_t i = 0; i < text.size(); ++i)
            if (text[i] == '\n') starts_.push_back(i + 1);
    }
    std::size_t offset(const toml::source_position& place) const
    {
        if (place.line < 1 || place.line > starts_.size()) return text_.size();
        std::size_t at = starts_[place.line - 1];
        for (std::size_t column = 1; column < place.column && at < text_.size(); ++column) {
            ++at;
            while (at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xc0u) == 0x80u) ++at;
        }
        return at;
    }
    std::string_view line(std::size_t number) const
    {
        if (number < 1 || number > starts_.size()) return {};
        const std::string_view rest = text_.substr(std::min(starts_[number - 1], text_.size()));
        return rest.substr(0, rest.find('\n'));
    }

private:
    std::string_view text_;
    std::vector<std::size_t> starts_;
};

std::string keyPart(std::string_view part)
{
    const bool bare = !part.empty() && std::ranges::all_of(part, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
    return bare ? std::string(part) : inQuotes(part);
}

std::string withoutCarriageReturns(std::string text)
{
    for (auto at = text.find("\r\n"); at != std::string::npos; at = text.find("\r\n", at)) text.erase(at, 1);
    return text;
}

TomlValue valueOf(const toml::node& node, int depth)
{
    if (const auto* flag = node.as_boolean()) return flag->get();
    if (const auto* integer = node.as_integer()) return integer->get();
    if (const auto* number = node.as_floating_point()) return number->get();
    if (const auto* text = node.as_string()) return withoutCarriageReturns(text->get());
    if (const auto* array = node.as_array(); array != nullptr && depth < deepest) {
        TomlArray values;
        values.elements.reserve(array->size());
        for (const toml::node& element : *array)
            values.elements.push_back({valueOf(element, depth + 1), static_cast<int>(element.source().begin.line)});
        return values;
    }
    return std::monostate{};
}

/// "abs.rail" of "abs.rail[3]".
std::string withoutNumbers(std::string_view key)
{
    std::string name;
    while (!key.empty()) {
        const std::size_t open = std::min(key.find('['), key.size());
        const std::size_t close = key.find(']', open);
        name += key.substr(0, open);
        key.remove_prefix(close == std::string_view::npos ? key.size() : close + 1);
    }
    return name;
}

class Flattener {
public:
    Flattener(std::string_view text, const Places& places, TomlDocument& document)
        : text_(text), places_(places), document_(document)
    {}

    void add(const toml::table& table, const std::string& prefix, int depth = 1)
    {
        for (const auto& [name, node] : table) {
            const std::string key = prefix + keyPart(name.str());
            addNode(node, key, static_cast<int>(name.source().begin.line), depth);
        }
    }

private:
    void addNode(const toml::node& node, const std::string& key, int line, int depth)
    {
        const std::size_t begin = places_.offset(node.source().begin);
        const std::size_t end = places_.offset(node.source().end);
        if (const toml::table* table = node.as_table(); table != nullptr && depth < deepest) {
            document_.tables.push_back({key, kindOf(*table, key, begin, end), line, begin, end});
            add(*table, key + '.', depth + 1);
        } else if (const toml::array* array = node.as_array(); array != nullptr && array->is_array_of_tables()) {
            document_.tables.push_back({key, TomlTableKind::Array, line, begin, end});
            for (std::size_t i = 0; i < array->size(); ++i)
                addNode(*array->get(i), key + '[' + std::to_string(i + 1) + ']',
                        static_cast<int>(array->get(i)->source().begin.line), depth);
        } else {
            document_.entries.push_back({key, valueOf(node, depth), line, begin, end});
        }
    }

    /// toml++ gives the table a of [a.b] the place of that header.
    TomlTableKind kindOf(const toml::table& table, const std::string& key, std::size_t begin, std::size_t end) const
    {
        if (table.is_inline()) return TomlTableKind::Inline;
        std::string header;
        for (const char c : text_.substr(begin, end - begin))
            if (c != ' ' && c != '\t') header += c;
        const std::string name = withoutNumbers(key);
        if (header == '[' + name + ']' || (header == "[[" + name + "]]" && key.ends_with(']')))
            return TomlTableKind::Header;
        return header.starts_with('[') ? TomlTableKind::Implied : TomlTableKind::Dotted;
    }

    std::string_view text_;
    const Places& places_;
    TomlDocument& document_;
};

/// What makes a text no TOML at all, before any parsing.
void checkText(std::string_view text, TomlDocument& document)
{
    const auto lineAt = [&](std::size_t at) {
        return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    };
    if (text.find('\0') != std::string_view::npos) {
        document.problem = "is not a text file";
        return;
    }
    if (const auto bad = findInvalidUtf8(text); bad != std::string_view::npos) {
        document.problem = "is not valid UTF-8 text";
        document.problemLine = lineAt(bad);
        return;
    }
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (end - begin > longestLine) {
            document.problem = "a line is longer than " + std::to_string(longestLine) + " bytes";
            document.problemLine = lineAt(begin);
            return;
        }
        begin = end + 1;
    }
}

/// The likeliest slip of all: cutoff = 7 nm.
bool lacksQuotationMarks(std::string_view line)
{
    const auto equals = line.find('=');
    if (equals == std::string_view::npos) return false;
    const auto value = line.find_first_not_of(" \t", equals + 1);
    if (value == std::string_view::npos ||
        std::string_view("+-.0123456789").find(line[value]) == std::string_view::npos)
        return false;
    const std::string_view rest = line.substr(value, line.find('#', value) - value);
    return std::ranges::any_of(rest,
                               [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%'; });
}

} // namespace

TomlDocument readToml(std::string_view text)
{
    TomlDocument document;
    checkText(text, document);
    if (!document.problem.empty()) return document;
    const Places places(text);
    try {
        Flattener(text, places, document).add(toml::parse(text), "");
    } catch (const toml::parse_error& error) {
        std::string what(error.description());
        // "Error while parsing key-value pair: expected value, saw '\n'"
        if (const auto colon = what.find(": "); what.starts_with("Error") && colon != std::string::npos)
            what.erase(0, colon + 2);
        const std::string_view line = places.line(error.source().begin.line);
        const std::string lineEnd = ", saw '\\n'";
        if (std::ranges::count(line, '"') % 2 == 1) what = "a quotation mark is missing";
        if (what.ends_with(lineEnd)) what.replace(what.size() - lineEnd.size(), lineEnd.size(), ", but the line ends");
        document = {};
        document.problem = "is not TOML: " + what;
        document.problemLine = static_cast<int>(error.source().begin.line);
        if (lacksQuotationMarks(line))
            document.problem += "; write a value with a unit in quotation marks, as \"7 nm\"";
        return document;
    }
    std::ranges::stable_sort(document.entries, {}, &TomlEntry::begin);
    std::ranges::stable_sort(document.tables, {}, &TomlTable::begin);
    return document;
}

std::string tomlString(std::string_view text)
{
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (c == '\n') {
            result += "\\n";
        } else if (c == '\t') {
            result += "\\t";
        } else if (byte < 0x20 || byte == 0x7f) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04X", static_cast<unsigned>(byte));
            result += escape;
        } else {
            result += c;
        }
    }
    return result + '"';
}

} // namespace touchdown
