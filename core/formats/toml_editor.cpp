// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/toml_editor.h"

#include <algorithm>

namespace touchdown {

TomlEditor::TomlEditor(const std::string& text, const TomlDocument& toml)
    : text_(text), toml_(toml), newline_(text.find("\r\n") == std::string::npos ? "\n" : "\r\n")
{}

void TomlEditor::put(const std::string& key, const std::string& value)
{
    const auto dot = key.find_last_of('.');
    const std::string line = key.substr(dot == std::string::npos ? 0 : dot + 1) + " = " + withLineEnds(value);
    if (const TomlEntry* entry = find(key))
        edits_.push_back({entry->begin, entry->end - entry->begin, withLineEnds(value)});
    else if (dot == std::string::npos)
        addToRoot(line);
    else
        addToTable(key.substr(0, dot), line);
}

void TomlEditor::remove(std::string_view key)
{
    const TomlEntry* entry = find(key);
    if (entry == nullptr) return;
    const auto dot = key.find_last_of('.');
    const TomlTable* table = dot == std::string_view::npos ? nullptr : findTable(key.substr(0, dot));
    if (table != nullptr && table->kind == TomlTableKind::Inline) return removeFromInline(*entry, *table);
    // With the line end before it rather than its own, behind which new lines may go.
    std::size_t begin = lineBegin(entry->begin);
    std::size_t end = lineEnd(entry->end);
    if (begin > 0) {
        begin -= text_.compare(begin - newline_.size(), newline_.size(), newline_) == 0 ? newline_.size() : 1;
        if (text_[end - 1] == '\n')
            end -= text_.compare(end - newline_.size(), newline_.size(), newline_) == 0 ? newline_.size() : 1;
    }
    edits_.push_back({begin, end - begin, ""});
}

/// With one of the commas beside it.
void TomlEditor::removeFromInline(const TomlEntry& entry, const TomlTable& table)
{
    std::size_t begin = text_.rfind('=', entry.begin);
    while (begin > table.begin && text_[begin - 1] != ',' && text_[begin - 1] != '{') --begin;
    std::size_t end = text_.find_first_not_of(" \t", entry.end);
    if (text_[end] == ',')
        ++end;
    else if (text_[begin - 1] == ',')
        --begin;
    edits_.push_back({begin, end - begin, ""});
}

void TomlEditor::removeTable(std::string_view name, std::size_t number)
{
    const TomlTable* table = findTable(std::string(name) + '[' + std::to_string(number) + ']');
    if (table == nullptr) return;
    const std::size_t begin = lineBegin(table->begin);
    edits_.push_back({begin, tableEnd(*table) - begin, ""});
}

void TomlEditor::insertTable(std::string_view name, std::size_t after, const std::string& table)
{
    const TomlTable* before = findTable(std::string(name) + '[' + std::to_string(after) + ']');
    const TomlTable* first = findTable(std::string(name) + "[1]");
    if (before != nullptr) {
        // The last line of the text may lack its end.
        const std::size_t at = tableEnd(*before);
        const bool ended = at > 0 && text_[at - 1] == '\n';
        edits_.push_back({at, 0, (ended ? "" : newline_) + newline_ + withLineEnds(table)});
    } else if (first != nullptr) {
        edits_.push_back({lineBegin(first->begin), 0, withLineEnds(table) + newline_});
    } else {
        appended_ += newline_ + withLineEnds(table);
    }
    appendedGroup_.clear();
}

std::string TomlEditor::result()
{
    std::ranges::stable_sort(edits_, {}, &Edit::at);
    std::string out;
    std::size_t done = 0;
    for (const Edit& edit : edits_) {
        if (edit.at > done) out.append(text_, done, edit.at - done);
        out += edit.inserted;
        done = std::max(done, edit.at + edit.removed);
    }
    out.append(text_, std::min(done, text_.size()));
    if (!appended_.empty() && !out.empty() && !out.ends_with('\n')) out += newline_;
    return out + appended_;
}

const TomlEntry* TomlEditor::find(std::string_view key) const
{
    const auto found = std::ranges::find(toml_.entries, key, &TomlEntry::key);
    return found == toml_.entries.end() ? nullptr : &*found;
}

const TomlTable* TomlEditor::findTable(std::string_view key) const
{
    const auto found = std::ranges::find(toml_.tables, key, &TomlTable::key);
    return found == toml_.tables.end() ? nullptr : &*found;
}

/// Whether a key is in a table; in the root for "".
bool TomlEditor::isBelow(std::string_view key, std::string_view group)
{
    return key.size() > group.size() && key.starts_with(group) && key[group.size()] == '.';
}

/// The header under which a key stands: "disk.surface" of "disk.surface.rms"; "" for the root.
std::string_view TomlEditor::headerOf(std::string_view key) const
{
    std::string_view header;
    for (const TomlTable& table : toml_.tables)
        if (table.kind == TomlTableKind::Header && isBelow(key, table.key) && table.key.size() > header.size())
            header = table.key;
    return header;
}

/// The last entry of a table, without those of [[tables]] and of tables with a header of their own in it; of the root
/// for "".
const TomlEntry* TomlEditor::lastEntry(std::string_view group) const
{
    const TomlEntry* last = nullptr;
    for (const TomlEntry& entry : toml_.entries) {
        const bool inside = group.empty()
                                ? entry.key.find('.') == std::string::npos
                                : isBelow(entry.key, group) && entry.key.find('[', group.size()) == std::string::npos &&
                                      headerOf(entry.key).size() <= group.size();
        if (inside) last = &entry;
    }
    return last;
}

std::size_t TomlEditor::lineBegin(std::size_t at) const
{
    const std::size_t end = at == 0 ? std::string::npos : text_.rfind('\n', at - 1);
    return end == std::string::npos ? 0 : end + 1;
}

/// One past the line's end.
std::size_t TomlEditor::lineEnd(std::size_t at) const
{
    const std::size_t end = text_.find('\n', at);
    return end == std::string::npos ? text_.size() : end + 1;
}

/// One past the last line of a table with a header.
std::size_t TomlEditor::tableEnd(const TomlTable& table) const
{
    const TomlEntry* last = lastEntry(table.key);
    return lineEnd(last != nullptr ? last->end : table.end);
}

std::string TomlEditor::withLineEnds(const std::string& value) const
{
    if (newline_ == "\n") return value;
    std::string text;
    for (const char c : value) text += c == '\n' ? newline_ : std::string(1, c);
    return text;
}

void TomlEditor::insertLineAfter(std::size_t at, const std::string& line)
{
    std::size_t end = std::min(text_.find('\n', at), text_.size());
    if (end > 0 && end < text_.size() && text_[end - 1] == '\r') --end;
    edits_.push_back({end, 0, newline_ + line});
}

void TomlEditor::addToRoot(const std::string& line)
{
    if (const TomlEntry* last = lastEntry("")) {
        insertLineAfter(last->end, line);
        return;
    }
    // Below the comment that opens the file, if an empty line follows it.
    std::size_t top = text_.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    std::size_t at = top;
    while (at < text_.size() && text_[at] == '#') at = std::min(text_.find('\n', at), text_.size() - 1) + 1;
    if (at < text_.size() && (text_[at] == '\n' || text_[at] == '\r')) top = at;
    edits_.push_back({top, 0, line + newline_});
}

void TomlEditor::addToTable(const std::string& group, const std::string& line)
{
    const TomlEntry* last = lastEntry(group);
    const TomlTable* table = findTable(group);
    if (table == nullptr || (table->kind == TomlTableKind::Implied && last == nullptr)) {
        if (group != appendedGroup_) appended_ += newline_ + '[' + group + ']' + newline_;
        appendedGroup_ = group;
        appended_ += line + newline_;
    } else if (table->kind == TomlTableKind::Inline) {
        // Before the closing brace; a second key needs its comma as well.
        const bool first = last == nullptr && inlineFilled_ != group;
        edits_.push_back({last != nullptr ? last->end : table->end - 1, 0, (first ? " " : ", ") + line});
        inlineFilled_ = group;
    } else if (table->kind == TomlTableKind::Header) {
        insertLineAfter(last != nullptr ? last->end : table->end, line);
    } else {
        const std::string_view header = headerOf(group);
        insertLineAfter(last != nullptr ? last->end : table->end,
                        group.substr(header.empty() ? 0 : header.size() + 1) + '.' + line);
    }
}

} // namespace touchdown
