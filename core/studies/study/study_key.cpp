// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study_key.h"

#include <algorithm>
#include <cmath>

#include "core/formats/toml_document.h"
#include "core/formats/units.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

constexpr std::size_t widestLine = 119;   // of a template [characters]
constexpr std::size_t widestSetting = 30; // beside which comments are aligned

/// Comment lines that break between words.
std::string comment(const std::string& text)
{
    std::string lines, line = "#";
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        if (line.size() + 1 + word.size() > widestLine) {
            lines += line + "\n";
            line = "#";
        }
        line += ' ' + word;
        at = end + 1;
    }
    return lines + line + "\n";
}

/// As a value of TOML.
std::string tomlDefault(const StudyKey& key)
{
    if (!key.shown.empty()) return tomlString(key.shown);
    if (const auto* list = std::get_if<std::vector<std::string>>(&key.standard)) {
        std::string text;
        for (const std::string& each : *list) text += (text.empty() ? "[" : ", ") + tomlString(each);
        return text + "]";
    }
    const bool bare = std::holds_alternative<bool>(key.standard) || std::holds_alternative<int>(key.standard) ||
                      (std::holds_alternative<double>(key.standard) && key.displayUnit.empty());
    return bare ? defaultText(key) : tomlString(defaultText(key));
}

std::string settingText(const StudyKey& key) { return leafOf(key.key) + " = " + tomlDefault(key); }

std::string lineText(const StudyKey& key, std::size_t width)
{
    const std::string mark = key.onlyOffered ? "# " : "";
    const std::string setting = mark + settingText(key);
    if (key.help.empty()) return setting + "\n";
    const std::string line = setting + std::string(setting.size() < width ? width - setting.size() : 0, ' ') + " # ";
    if (key.kind == StudyKeyKind::Choice)
        if (const std::string all = line + key.help + ": " + joined(key.choices); all.size() <= widestLine)
            return all + "\n";
    return line.size() + key.help.size() <= widestLine ? line + key.help + "\n" : comment(key.help) + setting + "\n";
}

} // namespace

StudyKey numberKey(std::string key, StudyDefault standard, std::string unit, std::string displayUnit, double minimum,
                   double maximum, std::string help)
{
    return {std::move(key),
            StudyKeyKind::Number,
            std::move(standard),
            std::move(help),
            std::move(unit),
            std::move(displayUnit),
            minimum,
            maximum};
}

StudyKey integerKey(std::string key, int standard, int minimum, int maximum, std::string help)
{
    return {std::move(key), StudyKeyKind::Integer, standard, std::move(help), "", "", double(minimum), double(maximum)};
}

StudyKey choiceKey(std::string key, std::string standard, std::vector<std::string> choices, std::string help)
{
    StudyKey row{std::move(key), StudyKeyKind::Choice, std::move(standard), std::move(help)};
    row.choices = std::move(choices);
    return row;
}

StudyKey textKey(std::string key, StudyDefault standard, std::string needed, std::string help)
{
    StudyKey row{std::move(key), StudyKeyKind::Text, std::move(standard), std::move(help)};
    row.needed = std::move(needed);
    return row;
}

StudyKey inList(StudyKey key)
{
    key.inList = true;
    return key;
}

StudyKey onlyOffered(StudyKey key)
{
    key.onlyOffered = true;
    return key;
}

std::string rangeText(double minimum, double maximum, const std::string& displayUnit)
{
    const std::string least = formatQuantity(minimum, displayUnit), most = formatQuantity(maximum, displayUnit);
    if (std::isfinite(minimum) && std::isfinite(maximum)) return "from " + least + " to " + most;
    if (std::isfinite(minimum)) return "at least " + least;
    return std::isfinite(maximum) ? "at most " + most : "a number";
}

std::string wholeRangeText(int minimum, int maximum)
{
    return "a whole number from " + std::to_string(minimum) + " to " + std::to_string(maximum);
}

std::string choiceText(const std::vector<std::string>& choices)
{
    return (choices.size() > 1 ? "one of " : "") + joined(choices);
}

std::string allowedText(const StudyKey& key)
{
    if (!key.needed.empty()) return key.needed;
    switch (key.kind) {
    case StudyKeyKind::Number: return rangeText(key.minimum, key.maximum, key.displayUnit);
    case StudyKeyKind::Integer: return wholeRangeText(static_cast<int>(key.minimum), static_cast<int>(key.maximum));
    case StudyKeyKind::Boolean: return "true or false";
    case StudyKeyKind::Choice: return choiceText(key.choices);
    case StudyKeyKind::Text: return neededText;
    case StudyKeyKind::List: return neededList;
    case StudyKeyKind::Settings: return neededSettings;
    case StudyKeyKind::Table: break;
    }
    return {};
}

std::string defaultText(const StudyKey& key)
{
    if (!key.shown.empty()) return key.shown;
    if (const auto* flag = std::get_if<bool>(&key.standard)) return *flag ? "true" : "false";
    if (const auto* whole = std::get_if<int>(&key.standard)) return std::to_string(*whole);
    if (const auto* number = std::get_if<double>(&key.standard)) return formatQuantity(*number, key.displayUnit);
    if (const auto* text = std::get_if<std::string>(&key.standard)) return *text;
    return std::holds_alternative<std::monostate>(key.standard) ? std::string() : tomlDefault(key);
}

std::string templateText(const StudyForm& form)
{
    std::string text = form.remark.empty() ? std::string() : comment(form.remark), tables;
    const auto isWritten = [](const StudyKey& key) {
        return !key.inList && !std::holds_alternative<std::monostate>(key.standard);
    };
    std::size_t width = 0;
    for (const StudyKey& key : form.keys)
        if (isWritten(key)) width = std::max(width, std::min(settingText(key).size(), widestSetting));
    for (const StudyKey& key : form.keys) {
        if (key.kind == StudyKeyKind::Table && !key.inList)
            tables += "\n" + comment(key.help) + (key.onlyOffered ? "# [" : "[") + key.key + "]\n";
        else if (isWritten(key))
            (tableOf(key.key).empty() ? text : tables) += lineText(key, width);
    }
    return text + form.lists + tables;
}

std::string settingKey(const std::string& key, const std::string& table)
{
    std::string name = key.substr(table.size() + 1);
    if (name.size() > 1 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
    return name;
}

std::string withoutNumbers(const std::string& key)
{
    std::string name;
    bool inside = false;
    for (const char c : key) {
        if (c == '[') inside = true;
        if (!inside) name += c;
        if (c == ']') inside = false;
    }
    return name;
}

std::string tableOf(const std::string& key)
{
    const auto mark = key.find('"'); // a part in quotation marks may hold dots
    const auto dot = mark == std::string::npos ? key.rfind('.') : mark == 0 ? mark : mark - 1;
    return dot == std::string::npos ? std::string() : key.substr(0, dot);
}

std::string leafOf(const std::string& key)
{
    const std::string table = tableOf(key);
    return table.empty() ? key : key.substr(table.size() + 1);
}

std::string ownerOf(const std::string& key)
{
    return key.ends_with(']') ? key.substr(0, key.rfind('[')) : tableOf(key);
}

} // namespace touchdown
