// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study_reader.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/case_files/case_reader.h"
#include "core/formats/decimal.h"
#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/formats/toml_quantity.h"
#include "core/studies/study/key_path.h"

namespace touchdown {

namespace {

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
    std::string list;
    for (const std::string& each : choices) list += (list.empty() ? "" : ", ") + each;
    return (choices.size() > 1 ? "one of " : "") + list;
}

/// A value as --set takes it; nothing where it is none.
std::optional<std::string> settingText(const TomlValue& value)
{
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
    if (const auto* number = std::get_if<double>(&value); number != nullptr && std::isfinite(*number))
        return decimalText(*number);
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    const auto* array = std::get_if<TomlArray>(&value);
    if (array == nullptr) return {};
    std::string list;
    for (const TomlElement& element : array->elements) {
        const auto one = std::holds_alternative<TomlArray>(element.value) ? std::nullopt : settingText(element.value);
        if (!one) return {};
        list += (list.empty() ? "" : ", ") + *one;
    }
    return list;
}

/// The values of a list, each as an element of its own; beside a file a text with commas is one, too. None where it is
/// no list.
std::vector<TomlValue> elementsOf(const TomlEntry& entry)
{
    std::vector<TomlValue> values;
    if (const auto* array = std::get_if<TomlArray>(&entry.value)) {
        for (const TomlElement& element : array->elements) values.push_back(element.value);
    } else if (entry.line == optionLine) {
        const auto* text = std::get_if<std::string>(&entry.value);
        if (text == nullptr) return {entry.value};
        for (const std::string_view element : listElements(*text)) values.push_back(std::string(element));
    }
    return values;
}

} // namespace

StudyReader::StudyReader(const TomlDocument& toml, std::string name, const Case& start,
                         std::vector<InputProblem>& problems)
    : toml_(toml), name_(std::move(name)), start_(start), problems_(problems)
{
    for (const TomlEntry& entry : toml_.entries) entries_[entry.key] = &entry;
    for (const TomlTable& table : toml_.tables) tables_[table.key] = &table;
}

bool StudyReader::has(const std::string& key)
{
    asked_.insert(key);
    return entries_.contains(key) || findTable(key) != nullptr;
}

void StudyReader::ask(const std::string& key, const std::string& answer, const std::string& unit,
                      const std::string& displayUnit)
{
    const std::string name = withoutNumbers(key);
    if (std::ranges::find(questions_, name, &StudyQuestion::key) == questions_.end())
        questions_.push_back({name, answer, unit, displayUnit});
}

std::optional<double> StudyReader::number(const std::string& key, const std::string& unit,
                                          const std::string& displayUnit, double minimum, double maximum)
{
    ask(key, rangeText(minimum, maximum, displayUnit), unit, displayUnit);
    const TomlEntry* entry = find(key);
    if (entry == nullptr) return {};
    return inRange(key, entry->value, unit, displayUnit, minimum, maximum);
}

std::optional<int> StudyReader::integer(const std::string& key, int minimum, int maximum)
{
    ask(key, wholeRangeText(minimum, maximum));
    const TomlEntry* entry = find(key);
    if (entry == nullptr) return {};
    const auto* value = std::get_if<std::int64_t>(&entry->value);
    if (value != nullptr && *value >= minimum && *value <= maximum) return static_cast<int>(*value);
    add(key, "must be " + wholeRangeText(minimum, maximum));
    return {};
}

std::optional<bool> StudyReader::boolean(const std::string& key)
{
    ask(key, "true or false");
    const TomlEntry* entry = find(key);
    if (entry == nullptr) return {};
    if (const auto* value = std::get_if<bool>(&entry->value)) return *value;
    add(key, "has the wrong type; true or false is needed");
    return {};
}

std::optional<std::string> StudyReader::text(const std::string& key, const std::string& needed)
{
    ask(key, needed);
    const TomlEntry* entry = find(key);
    if (entry == nullptr) return {};
    if (const auto* value = std::get_if<std::string>(&entry->value)) return *value;
    add(key, "has the wrong type; " + needed + " is needed");
    return {};
}

std::optional<std::string> StudyReader::choice(const std::string& key, const std::vector<std::string>& choices)
{
    ask(key, choiceText(choices));
    const auto value = text(key);
    if (!value || std::ranges::find(choices, *value) != choices.end()) return value;
    add(key, inQuotes(*value) + " is not known: allowed is " + choiceText(choices) +
                 didYouMean(nearestName(*value, choices)));
    return {};
}

std::optional<std::vector<std::string>> StudyReader::texts(const std::string& key, const std::string& needed)
{
    ask(key, needed);
    const TomlEntry* entry = find(key);
    if (entry == nullptr) return {};
    std::vector<std::string> list;
    for (const TomlValue& element : elementsOf(*entry)) {
        const auto value = std::holds_alternative<TomlArray>(element) ? std::nullopt : settingText(element);
        if (!value) {
            list.clear();
            break;
        }
        list.push_back(*value);
    }
    if (!list.empty()) return list;
    add(key, "has the wrong type; " + needed + " is needed");
    return {};
}

std::optional<std::vector<double>> StudyReader::numbers(const std::string& key, const std::string& unit,
                                                        const std::string& displayUnit, double minimum, double maximum)
{
    ask(key, "a list of numbers, each " + rangeText(minimum, maximum, displayUnit), unit, displayUnit);
    const TomlEntry* entry = find(key);
    if (entry == nullptr) return {};
    std::vector<double> list;
    for (const TomlValue& element : elementsOf(*entry)) {
        const auto value = inRange(key, element, unit, displayUnit, minimum, maximum);
        if (!value) return {};
        list.push_back(*value);
    }
    if (!list.empty()) return list;
    const std::string one = displayUnit.empty() ? "1" : "\"1 " + displayUnit + '"';
    add(key, "has the wrong type; a list such as [" + one + ", " + one + "] is needed");
    return {};
}

std::vector<std::pair<std::string, std::string>> StudyReader::settings(const std::string& table)
{
    const std::string needed = "a table such as { \"run.duration\" = \"1 ms\" }";
    ask(table, needed);
    std::vector<std::pair<std::string, std::string>> list;
    settled_.insert(table);
    if (entries_.contains(table) || (findTable(table) != nullptr && findTable(table)->kind == TomlTableKind::Array))
        add(table, "must be " + needed);
    for (const TomlEntry& entry : toml_.entries) {
        if (!entry.key.starts_with(table + '.')) continue;
        if (auto value = settingText(entry.value))
            list.emplace_back(settingKey(entry.key, table), std::move(*value));
        else
            addAt(entry.line, entry.key,
                  "has the wrong type; a text, a number, true, false or a list of these is needed");
    }
    return list;
}

std::vector<std::string> StudyReader::tables(const std::string& list)
{
    asked_.insert(list);
    std::vector<std::string> names;
    const auto entry = entries_.find(list);
    const bool given = entry != entries_.end();
    const auto* array = given ? std::get_if<TomlArray>(&entry->second->value) : nullptr;
    const TomlTable* table = findTable(list);
    if ((given && (array == nullptr || !array->elements.empty())) ||
        (table != nullptr && table->kind != TomlTableKind::Array)) {
        add(list, lineOf(list) == optionLine ? "is of a list of tables; it stands in the study's file"
                                             : "is one of a list; write [[" + list + "]]");
        settled_.insert(list);
        return names;
    }
    for (const TomlTable& each : toml_.tables) {
        if (!each.key.starts_with(list + '[') || each.key.find(']', list.size()) + 1 != each.key.size()) continue;
        names.push_back(each.key);
        asked_.insert(each.key);
    }
    return names;
}

void StudyReader::allow(const std::string& table, const std::vector<std::string>& names)
{
    for (const std::string& each : names) asked_.insert(table.empty() ? each : table + '.' + each);
}

void StudyReader::add(const std::string& key, std::string message) { addAt(lineOf(key), key, std::move(message)); }

int StudyReader::lineOf(const std::string& key) const
{
    if (const auto entry = entries_.find(key); entry != entries_.end()) return entry->second->line;
    for (std::string table = key; !table.empty(); table = tableOf(table))
        if (const TomlTable* found = findTable(table)) return found->line;
    return 0;
}

void StudyReader::finish()
{
    std::map<std::string, std::set<std::string>> namesIn; // each table; lists without their numbers
    for (const std::string& key : asked_)
        for (std::string name = withoutNumbers(key); !name.empty(); name = tableOf(name))
            namesIn[tableOf(name)].insert(leafOf(name));
    const auto suggestion = [&](const std::string& key) {
        const std::string name = withoutNumbers(key);
        const std::set<std::string>& names = namesIn[tableOf(name)];
        return didYouMean(nearestName(leafOf(name), {names.begin(), names.end()}));
    };
    std::set<std::string> done = settled_;
    const auto inside = [&](std::string key) {
        while (!key.empty() && !done.contains(key)) key = ownerOf(key);
        return !key.empty();
    };
    const auto begun = [&](const std::string& prefix) {
        const auto first = asked_.lower_bound(prefix);
        return first != asked_.end() && first->starts_with(prefix);
    };
    const auto isKnown = [&](const std::string& table) {
        return asked_.contains(table) || begun(table + '.') || begun(table + '[');
    };
    for (const TomlTable& table : toml_.tables) {
        if (inside(table.key) || isKnown(table.key)) continue;
        done.insert(table.key);
        addAt(table.line, table.key, "unknown table" + suggestion(table.key));
    }
    for (const TomlEntry& entry : toml_.entries) {
        if (inside(entry.key)) continue;
        if (!asked_.contains(entry.key))
            addAt(entry.line, entry.key, "unknown key" + suggestion(entry.key));
        else if (begun(entry.key + '.'))
            addAt(entry.line, entry.key, "is a table, not a value; write [" + entry.key + "]");
    }
}

/// A value; where a table stands instead, that is told once.
const TomlEntry* StudyReader::find(const std::string& key)
{
    asked_.insert(key);
    if (const auto found = entries_.find(key); found != entries_.end()) return found->second;
    if (findTable(key) != nullptr && settled_.insert(key).second) add(key, "is a table, not a value");
    return nullptr;
}

const TomlTable* StudyReader::findTable(const std::string& key) const
{
    const auto found = tables_.find(key);
    return found == tables_.end() ? nullptr : found->second;
}

std::optional<double> StudyReader::inRange(const std::string& key, const TomlValue& value, const std::string& unit,
                                           const std::string& displayUnit, double minimum, double maximum)
{
    const auto number = tomlQuantity(value, unit, displayUnit);
    if (const auto* problem = std::get_if<UnitProblem>(&number)) {
        add(key, problem->message);
        return {};
    }
    const double read = std::get<double>(number);
    if (read >= minimum && read <= maximum) return read;
    const bool bare = !unit.empty() && !std::holds_alternative<std::string>(value);
    add(key, "must be " + rangeText(minimum, maximum, displayUnit) +
                 (bare ? "; a number without its unit is in " + unit : ""));
    return {};
}

void StudyReader::addAt(int line, const std::string& key, std::string message)
{
    const bool option = line == optionLine;
    problems_.push_back({option ? "--option" : name_, option ? 0 : line, shortenedKey(key), std::move(message)});
}

} // namespace touchdown
