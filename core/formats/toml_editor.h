// SPDX-License-Identifier: GPL-3.0-or-later
//
// Puts values into a TOML text that a person wrote: comments, order and spelling of everything else are kept.
#pragma once

#include "core/formats/toml_document.h"

#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

/// Collects changes by key; `text` and `toml`, the result of readToml for it, must outlive it.
class TomlEditor {
public:
    TomlEditor(const std::string& text, const TomlDocument& toml);

    bool has(std::string_view key) const { return find(key) != nullptr; }
    /// Sets the value of "table.key", as TOML; new keys go below the last one of their table, new tables to the end.
    void put(const std::string& key, const std::string& value);
    /// Removes a key and its value, with the comment behind it.
    void remove(std::string_view key);

    /// Removes the table [[name]] with this number in the text, counted from 1.
    void removeTable(std::string_view name, std::size_t number);
    /// Adds a table "[[name]]\n..." behind number `after` of that name; 0: before the first one, or at the end of the
    /// text.
    void insertTable(std::string_view name, std::size_t after, const std::string& table);

    /// The text with all changes.
    std::string result();

private:
    /// `inserted` replaces `removed` bytes at `at`.
    struct Edit {
        std::size_t at = 0;
        std::size_t removed = 0;
        std::string inserted;
    };

    const TomlEntry* find(std::string_view key) const;
    void removeFromInline(const TomlEntry& entry, const TomlTable& table);
    const TomlTable* findTable(std::string_view key) const;
    static bool isBelow(std::string_view key, std::string_view group);
    std::string_view headerOf(std::string_view key) const;
    const TomlEntry* lastEntry(std::string_view group) const;
    std::size_t lineBegin(std::size_t at) const;
    std::size_t lineEnd(std::size_t at) const;
    std::size_t tableEnd(const TomlTable& table) const;
    std::string withLineEnds(const std::string& value) const;
    void insertLineAfter(std::size_t at, const std::string& line);
    void addToRoot(const std::string& line);
    void addToTable(const std::string& group, const std::string& line);

    const std::string& text_;
    const TomlDocument& toml_;
    std::string newline_;
    std::vector<Edit> edits_;
    std::string appended_; // tables that the text lacks
    std::string appendedGroup_;
    std::string inlineFilled_;
};

} // namespace touchdown
