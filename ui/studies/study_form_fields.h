// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which fields the form of a study has, and their names: the keys of the study itself and of its single tables, and for
// each table of a list, such as [[target]], the keys of one table ("target[2].value"). Numbers of the case have labels.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <QString>

#include "core/formats/toml_document.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

struct Case;

/// A list of tables of a study: [[name]].
struct FormList {
    std::string name;
    std::size_t rows = 0;     // 0, too, where only the text shows the tables
    bool onlyText = false;    // tables without a header, or too many
    bool areDefaults = false; // the text has no list: the study takes these rows
    bool operator==(const FormList&) const = default;
};

struct FormFields {
    std::vector<StudyKey> keys;  // of the study itself
    std::vector<StudyKey> cells; // of the rows of all lists, with the number of the row in the key
    std::vector<FormList> lists;
    bool operator==(const FormFields&) const = default;
};

/// Of a text that can be read; `c`: the case that is studied. A number of a row has the unit of the row's quantity.
FormFields fieldsOf(const StudyForm& form, const TomlDocument& toml, const Case& c);
/// The same text; where it has no list of the form, with the tables that the study then takes.
TomlDocument withDefaultLists(TomlDocument toml, const StudyForm& form);

/// nullptr where the text lacks the key.
const TomlEntry* entryOf(const TomlDocument& toml, const std::string& key);
/// "time_limit" as "Time limit", "map.x_from" as "Map: x from".
QString fieldLabel(const std::string& key);
/// Of a field of a row: "target[2].value" as "Wanted".
QString columnLabel(const std::string& key);
/// Of any key that a problem of a text names: "method[2].name" as "Method 2: name", set."run.step" as "Time step".
QString keyLabel(const std::string& key);

/// Whether the value of this key of a study is a key of the case.
bool takesCaseKey(const std::string& key);
/// The numbers that the case has, those of its rails too: label and key, "Rail 2: recess" and "abs.rail[2].recess".
std::vector<std::pair<QString, std::string>> caseNumbers(const Case& c);
/// "Minimum spacing (nm)" of minimum_spacing; "" where a static state has no such quantity.
QString quantityLabel(const std::string& name);

} // namespace touchdown
