// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of a study's file as its study asks for them. Every problem is collected, with line, key and what is
// allowed; a key that nobody has asked for is unknown. So a study asks for all its keys before it says that it cannot
// do this case.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/case_files/case_file.h"
#include "core/formats/toml_document.h"
#include "core/simulation/recording/quantity.h"

namespace touchdown {

/// The line of an entry that does not stand in the file but was given beside it; its problems name "--option" as their
/// file.
inline constexpr int optionLine = -1;

/// A key that a study asks for, and what it takes.
struct StudyQuestion {
    std::string key;                   // "repeats", "method.name"
    std::string answer;                // "from 1 nm to 9 nm", "one of run, static"
    std::string unit{}, displayUnit{}; // of a number; empty where there is none
};

class StudyReader {
public:
    /// All must last. `start` is the case that is studied.
    StudyReader(const TomlDocument& toml, std::string name, const Case& start, std::vector<InputProblem>& problems);

    /// What outlives the reader keeps a copy.
    const Case& start() const { return start_; }

    const std::string& name() const { return name_; }

    bool has(const std::string& key);
    /// Each is empty where the key is missing, and after it has added the problem where its value is of no use.
    std::optional<double> number(const std::string& key, const std::string& unit, const std::string& displayUnit,
                                 double minimum, double maximum);
    std::optional<int> integer(const std::string& key, int minimum, int maximum);
    std::optional<bool> boolean(const std::string& key);
    std::optional<std::string> text(const std::string& key, const std::string& needed = "text in quotation marks");
    std::optional<std::string> choice(const std::string& key, const std::vector<std::string>& choices);
    /// An array of one element or more, numbers as they are written. Beside a file a text with commas or a single value
    /// does, too.
    std::optional<std::vector<std::string>> texts(const std::string& key,
                                                  const std::string& needed = "a list of texts or numbers");
    std::optional<std::vector<double>> numbers(const std::string& key, const std::string& unit,
                                               const std::string& displayUnit, double minimum, double maximum);
    /// "key = value" pairs of a table within one: set = { "film.nodes" = [97, 97] }; each value as --set takes it.
    std::vector<std::pair<std::string, std::string>> settings(const std::string& table);
    /// The tables of a list: "method[1]", "method[2]"; asking for "method[1].name" reads it.
    std::vector<std::string> tables(const std::string& list);
    /// Keys of a table, "" for the root, that are no mistake where this study does not come to ask for them.
    void allow(const std::string& table, const std::vector<std::string>& names);
    /// A problem of a key, or of a table.
    void add(const std::string& key, std::string message);
    /// Where a key stands, or the table in which it is missing; 0 if there is neither.
    int lineOf(const std::string& key) const;

    /// Says which keys nobody has asked for.
    void finish();

    /// What was asked for until now, in that order; keys of a list of tables once.
    const std::vector<StudyQuestion>& questions() const { return questions_; }

private:
    void ask(const std::string& key, const std::string& answer, const std::string& unit = {},
             const std::string& displayUnit = {});
    const TomlEntry* find(const std::string& key);
    const TomlTable* findTable(const std::string& key) const;
    std::optional<double> inRange(const std::string& key, const TomlValue& value, const std::string& unit,
                                  const std::string& displayUnit, double minimum, double maximum);
    void addAt(int line, const std::string& key, std::string message);

    const TomlDocument& toml_;
    std::string name_;
    const Case& start_;
    std::vector<InputProblem>& problems_;
    std::map<std::string, const TomlEntry*> entries_;
    std::map<std::string, const TomlTable*> tables_;
    std::set<std::string> asked_;
    std::vector<StudyQuestion> questions_;
    std::set<std::string> settled_; // tables whose keys are of no more interest
};

} // namespace touchdown
