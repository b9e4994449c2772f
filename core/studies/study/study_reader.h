// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the keys of a study's file. Every problem is collected, with its line, its key and what is allowed. A key that
// is neither in the study's table of keys nor was read is unknown.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/case_files/case_settings.h"
#include "core/case_files/outside_path.h"
#include "core/formats/input_problem.h"
#include "core/formats/toml_document.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

struct Case;

/// The line of an entry that was given by --option; its problems name "--option" as their file.
inline constexpr int optionLine = -1;

class StudyReader {
public:
    /// All arguments must outlive the reader. `start` is the case that is studied.
    StudyReader(const TomlDocument& toml, std::string name, const Case& start, std::vector<InputProblem>& problems);

    const Case& start() const { return start_; }
    const std::string& name() const { return name_; }
    /// The folder of the study's file, empty for none, the "key=value" of --set, and whether files outside the folders
    /// may be named: for the cases that the study names.
    void setPlace(std::filesystem::path folder, std::vector<std::string> caseSettings, OutsidePaths outside)
    {
        folder_ = std::move(folder);
        caseSettings_ = std::move(caseSettings);
        outsidePaths_ = outside;
    }
    OutsidePaths outsidePaths() const { return outsidePaths_; }
    const std::filesystem::path& folder() const { return folder_; }
    const std::vector<std::string>& caseSettings() const { return caseSettings_; }
    /// The files of the cases that the study names; some more than once.
    const std::vector<std::filesystem::path>& inputs() const { return inputs_; }
    void addInputs(const std::vector<std::filesystem::path>& files)
    {
        inputs_.insert(inputs_.end(), files.begin(), files.end());
    }
    /// The keys of the study for this case.
    void setKeys(std::vector<StudyKey> keys);

    bool has(const std::string& key);
    /// The value of a key of the table; its default where the file does not give it, or gives a wrong one, which is
    /// added to the problems. The key is in the table and has a default.
    double number(const std::string& key);
    int integer(const std::string& key);
    bool flag(const std::string& key);
    std::string choice(const std::string& key);

    /// Each returns nothing where the key is missing, and where its value is wrong, which is added to the problems.
    std::optional<double> number(const std::string& key, const std::string& unit, const std::string& displayUnit,
                                 double minimum, double maximum);
    std::optional<int> integer(const std::string& key, int minimum, int maximum);
    std::optional<bool> boolean(const std::string& key);
    std::optional<std::string> text(const std::string& key, const std::string& needed = neededText);
    std::optional<std::string> choice(const std::string& key, const std::vector<std::string>& choices);
    /// An array of one element or more, numbers as they are written. As an option also a text with commas or a single
    /// value.
    std::optional<std::vector<std::string>> texts(const std::string& key, const std::string& needed = neededList);
    std::optional<std::vector<double>> numbers(const std::string& key, const std::string& unit,
                                               const std::string& displayUnit, double minimum, double maximum);
    /// "key = value" pairs of a table within one: set = { "film.nodes" = [97, 97] }; each value as --set takes it.
    std::vector<CaseSetting> settings(const std::string& table);
    /// A problem of values that these tables of settings gave: it belongs to its key in the first table that has it,
    /// else to `owner`.
    void addOfSettings(const std::string& owner, const std::vector<std::string>& tables, const InputProblem& problem);
    /// The tables of a list: "method[1]", "method[2]"; asking for "method[1].name" reads it.
    std::vector<std::string> tables(const std::string& list);
    /// A problem of a key, or of a table; reported once, however often it is added.
    void add(const std::string& key, std::string message);
    /// The line of a key, or of the table in which it is missing; 0 if there is neither.
    int lineOf(const std::string& key) const;

    /// Adds a problem for each unknown key and table.
    void finish();

private:
    const StudyKey& rowOf(const std::string& key) const;
    const TomlEntry* find(const std::string& key);
    const TomlTable* findTable(const std::string& key) const;
    std::optional<double> inRange(const std::string& key, const TomlValue& value, const std::string& unit,
                                  const std::string& displayUnit, double minimum, double maximum);
    void addAt(int line, const std::string& key, std::string message);

    const TomlDocument& toml_;
    std::string name_;
    const Case& start_;
    std::vector<InputProblem>& problems_;
    std::filesystem::path folder_;
    OutsidePaths outsidePaths_ = OutsidePaths::Refused;
    std::vector<std::string> caseSettings_;
    std::vector<std::filesystem::path> inputs_;
    std::map<std::string, const TomlEntry*> entries_;
    std::map<std::string, const TomlTable*> tables_;
    std::vector<StudyKey> keys_;
    std::set<std::string> known_;   // of keys_, with their tables; those of lists without numbers
    std::set<std::string> asked_;   // keys and tables that were read
    std::set<std::string> settled_; // tables whose keys are not checked any more
    std::set<std::string> told_;    // problems, with their lines
};

} // namespace touchdown
