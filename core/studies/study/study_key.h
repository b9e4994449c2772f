// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of a study as a table: what each one takes, its default for a case, and what it means. The reader's checks,
// the template and `touchdown describe study.KIND` are made from this table.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace touchdown {

enum class StudyKeyKind : std::uint8_t { Number, Integer, Boolean, Choice, Text, List, Settings, Table };

/// Monostate: the key has no default.
using StudyDefault = std::variant<std::monostate, bool, int, double, std::string, std::vector<std::string>>;

struct StudyKey {
    std::string key; // "hold", "ensemble.starts"; "method.name" of each of [[method]]
    StudyKeyKind kind = StudyKeyKind::Text;
    StudyDefault standard{};
    std::string help{};                  // without a full stop
    std::string unit{}, displayUnit{};   // of a number; empty when dimensionless
    double minimum = 0.0, maximum = 0.0; // of a number [unit] or an integer
    std::vector<std::string> choices{};
    std::string needed{};     // of a text: "a key of the case in quotation marks"
    std::string shown{};      // the default as the template writes it, "1%"; empty: as `standard` says
    bool onlyOffered = false; // the template writes it as a comment
    bool inList = false;      // of each table of a list
    bool operator==(const StudyKey&) const = default;
};

StudyKey numberKey(std::string key, StudyDefault standard, std::string unit, std::string displayUnit, double minimum,
                   double maximum, std::string help);
StudyKey integerKey(std::string key, int standard, int minimum, int maximum, std::string help);
inline StudyKey booleanKey(std::string key, bool standard, std::string help)
{
    return {std::move(key), StudyKeyKind::Boolean, standard, std::move(help)};
}
StudyKey choiceKey(std::string key, std::string standard, std::vector<std::string> choices, std::string help);
StudyKey textKey(std::string key, StudyDefault standard, std::string needed, std::string help);
/// Of texts or numbers.
inline StudyKey listKey(std::string key, StudyDefault standard, std::string help)
{
    return {std::move(key), StudyKeyKind::List, std::move(standard), std::move(help)};
}
/// Changes of the case: { "run.duration" = "1 ms" }.
inline StudyKey settingsKey(std::string key, std::string help)
{
    return {std::move(key), StudyKeyKind::Settings, {}, std::move(help)};
}
/// A table of the file; its keys follow it.
inline StudyKey tableKey(std::string key, std::string help)
{
    return {std::move(key), StudyKeyKind::Table, {}, std::move(help)};
}
StudyKey inList(StudyKey key);
StudyKey onlyOffered(StudyKey key);

inline constexpr const char* neededText = "text in quotation marks";
inline constexpr const char* neededList = "a list of texts or numbers";
inline constexpr const char* neededSettings = "a table such as { \"run.duration\" = \"1 ms\" }";

/// "from 1 nm to 9 nm", "at least 0 nm", "a number".
std::string rangeText(double minimum, double maximum, const std::string& displayUnit);
std::string wholeRangeText(int minimum, int maximum);
/// "one of run, static".
std::string choiceText(const std::vector<std::string>& choices);
/// What the key takes: one of the texts above, or what is needed.
std::string allowedText(const StudyKey& key);
/// "2000 us", "40"; empty where there is no default.
std::string defaultText(const StudyKey& key);

/// What a study asks for of a case.
struct StudyForm {
    std::vector<StudyKey> keys;
    std::string remark{}; // above the keys of a template, in a sentence or more; may be empty
    std::string lists{};  // the lists of tables of the template, as TOML
};
/// The text of a study with all defaults, with the help of each key as a comment; no line has more than 119 characters.
std::string templateText(const StudyForm& form);

// The parts of a dotted key of TOML, "method[2].set.\"run.step\"".

/// "run.step" of "set.\"run.step\"" and of "set.run.step", where the table is "set".
std::string settingKey(const std::string& key, const std::string& table);
/// "method.name" of "method[2].name".
std::string withoutNumbers(const std::string& key);
/// "method[2]" of "method[2].name"; "" of a root key.
std::string tableOf(const std::string& key);
/// "name" of "method.name".
std::string leafOf(const std::string& key);
/// "method" of "method[2]", and "method[2]" of "method[2].name".
std::string ownerOf(const std::string& key);

} // namespace touchdown
