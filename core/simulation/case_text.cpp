// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cases as TOML text: written anew, or with new values put into a text that somebody wrote.
#include "core/simulation/case_file.h"

#include "core/simulation/fields.h"
#include "core/simulation/toml_document.h"
#include "core/simulation/units.h"

#include <algorithm>
#include <array>
#include <optional>

namespace touchdown {

namespace {

std::string_view groupComment(std::string_view group)
{
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> comments{{
        {"about", "What this case is about."},
        {"slider", "The slider as a rigid body."},
        {"springs", "The air bearing: two nonlinear springs with dashpots, given at the static state."},
        {"suspension", "The suspension, about the static state."},
        {"ono_yamane", "Contact and adhesion: the simplified characteristic of Ono and Yamane, and the pad."},
        {"initial", "The start."},
        {"run", "The integration."},
        {"spectrum", "The power spectra."},
    }};
    for (const auto& [name, comment] : comments)
        if (name == group) return comment;
    return {};
}

/// The value with the quotation marks that TOML wants.
std::string tomlValue(const Case& c, const Field& field)
{
    const std::string text = toText(c, field);
    switch (field.kind) {
    case FieldKind::Text:
    case FieldKind::Choice: return tomlString(text);
    case FieldKind::Integer:
    case FieldKind::Boolean: return text;
    case FieldKind::Number: break;
    }
    // Without a unit it is an SI number that no text in the display unit gives.
    return text.find(' ') == std::string::npos ? text : tomlString(text);
}

std::string_view leaf(const Field& field)
{
    return std::string_view(field.key).substr(field.key.find_last_of('.') + 1);
}

bool sameCase(const Case& a, const Case& b)
{
    return std::ranges::all_of(fields(), [&](const Field& field) { return field.get(a) == field.get(b); });
}

/// The problems of single values; those of combinations were read well.
std::vector<InputProblem> valueProblems(const CaseDocument& document)
{
    const std::vector<CaseProblem> combinations = checkCombinations(document.value);
    std::vector<InputProblem> problems = document.problems;
    std::erase_if(problems, [&](const InputProblem& problem) {
        return std::ranges::find(combinations, problem.message, &CaseProblem::message) != combinations.end();
    });
    return problems;
}

/// A change of a text: `removed` bytes at `at` make place for `inserted`.
struct Edit {
    std::size_t at = 0;
    std::size_t removed = 0;
    std::string inserted;
};

/// Collects the changes that turn the values of a text into those of a case.
class TextEditor {
public:
    explicit TextEditor(const std::string& text)
        : text_(text), toml_(readToml(text)), newline_(text.find("\r\n") == std::string::npos ? "\n" : "\r\n")
    {}
    bool readable() const { return toml_.problem.empty(); }
    bool has(const Field& field) const { return find(field) != toml_.entries.end(); }

    void put(const Field& field, const std::string& value)
    {
        if (const auto entry = find(field); entry != toml_.entries.end())
            edits_.push_back({entry->begin, entry->end - entry->begin, value});
        else if (field.group().empty())
            addToRoot(field.key + " = " + value);
        else
            addToTable(field, value);
    }

    std::string result()
    {
        std::ranges::stable_sort(edits_, {}, &Edit::at);
        std::string out;
        std::size_t done = 0;
        for (const Edit& edit : edits_) {
            out.append(text_, done, edit.at - done).append(edit.inserted);
            done = edit.at + edit.removed;
        }
        out.append(text_, done);
        if (!appended_.empty() && !out.empty() && !out.ends_with('\n')) out += newline_;
        return out + appended_;
    }

private:
    std::vector<TomlEntry>::const_iterator find(const Field& field) const
    {
        return std::ranges::find(toml_.entries, field.key, &TomlEntry::key);
    }

    /// The last entry of a table; of the root for "".
    const TomlEntry* lastEntry(std::string_view group) const
    {
        const TomlEntry* last = nullptr;
        for (const TomlEntry& entry : toml_.entries) {
            const bool inside = group.empty() ? entry.key.find('.') == std::string::npos
                                              : entry.key.starts_with(std::string(group) + '.');
            if (inside) last = &entry;
        }
        return last;
    }

    void insertLineAfter(std::size_t at, const std::string& line)
    {
        std::size_t end = std::min(text_.find('\n', at), text_.size());
        if (end > 0 && end < text_.size() && text_[end - 1] == '\r') --end;
        edits_.push_back({end, 0, newline_ + line});
    }

    void addToRoot(const std::string& line)
    {
        if (const TomlEntry* last = lastEntry("")) {
            insertLineAfter(last->end, line);
            return;
        }
        // Below the comment that opens the file, if an empty line parts it from what follows.
        std::size_t top = text_.starts_with("\xEF\xBB\xBF") ? 3 : 0;
        std::size_t at = top;
        while (at < text_.size() && text_[at] == '#') at = std::min(text_.find('\n', at), text_.size() - 1) + 1;
        if (at < text_.size() && (text_[at] == '\n' || text_[at] == '\r')) top = at;
        edits_.push_back({top, 0, line + newline_});
    }

    void addToTable(const Field& field, const std::string& value)
    {
        const std::string group = field.group();
        const std::string line = std::string(leaf(field)) + " = " + value;
        const TomlEntry* last = lastEntry(group);
        const auto table = std::ranges::find(toml_.tables, group, &TomlTable::key);
        if (table == toml_.tables.end()) {
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
            insertLineAfter(last != nullptr ? last->end : table->end, group + '.' + line);
        }
    }

    const std::string& text_;
    TomlDocument toml_;
    std::string newline_;
    std::vector<Edit> edits_;
    std::string appended_; // tables that the text lacks
    std::string appendedGroup_;
    std::string inlineFilled_;
};

} // namespace

std::string formatCase(const Case& c)
{
    const Case defaults;
    std::string text;
    std::string group;
    for (const Field& field : fields()) {
        // What the model does not use is kept where somebody set it.
        const bool set = field.get(c) != field.get(defaults);
        if (!set && (!field.used(c) || field.group() == "about")) continue;
        if (field.group() != group) {
            group = field.group();
            text += "\n# " + std::string(groupComment(group)) + "\n[" + group + "]\n";
        }
        text += std::string(leaf(field)) + " = " + tomlValue(c, field);
        text += field.symbol.empty() ? "\n" : " # " + field.symbol + "\n";
    }
    return text;
}

std::string updateCaseText(const std::string& text, const Case& c)
{
    TextEditor editor(text);
    if (!editor.readable()) return formatCase(c);
    const CaseDocument old = parseCase(text, "");
    const std::vector<InputProblem> unread = valueProblems(old);
    for (const Field& field : fields()) {
        // A value that could not be read is put right even where the default that stood in for it is wanted.
        const bool bad = editor.has(field) && std::ranges::any_of(unread, [&](const InputProblem& problem) {
                             return problem.key == field.key;
                         });
        if (bad || field.get(old.value) != field.get(c)) editor.put(field, tomlValue(c, field));
    }
    std::string updated = editor.result();
    // Rather a plain text than a wrong one, should a shape of TOML have been overlooked.
    const CaseDocument check = parseCase(updated, "");
    const bool broken =
        std::ranges::any_of(check.problems, [](const InputProblem& problem) { return problem.key.empty(); });
    return !broken && sameCase(check.value, c) ? updated : formatCase(c);
}

} // namespace touchdown
