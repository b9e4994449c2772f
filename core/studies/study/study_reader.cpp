// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study_reader.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/case_files/case_reader.h"
#include "core/formats/decimal.h"
#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/formats/toml_quantity.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

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
    std::vector<std::string> list;
    for (const TomlElement& element : array->elements) {
        const auto one = std::holds_alternative<TomlArray>(element.value) ? std::nullopt : settingText(element.value);
        if (!one) return {};
        list.push_back(*one);
    }
    return joined(list);
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
        for (const std::string_view element : listElements(*text))
            values.emplace_back(std::in_place_type<std::string>, element);
    }
    return values;
}

/// What is wrong with an entry that gives no element of a list.
std::string faultOf(const TomlEntry& entry)
{
    const auto* array = std::get_if<TomlArray>(&entry.value);
    return array != nullptr && array->elements.empty() ? "is empty; " : "has the wrong type; ";
}

} // namespace

StudyReader::StudyReader(const TomlDocument& toml, std::string name, const Case& start,
                         std::vector<InputProblem>& problems)
    : toml_(toml), name_(std::move(name)), start_(start), problems_(problems)
{
    for (const TomlEntry& entry : toml_.entries) entries_[entry.key] = &entry;
    for (const TomlTable& table : toml_.tables) tables_[table.key] = &table;
}

void StudyReader::setKeys(std::vector<StudyKey> keys)
{
    keys_ = std::move(keys);
    for (const StudyKey& row : keys_)
        for (std::string name = row.key; !name.empty(); name = tableOf(name)) known_.insert(name);
}

bool StudyReader::has(const std::string& key)
{
    asked_.insert(key);
    return entries_.contains(key) || findTable(key) != nullptr;
}

const StudyKey& StudyReader::rowOf(const std::string& key) const
{
    const auto row = std::ranges::find(keys_, key, &StudyKey::key);
    assert(row != keys_.end());
    return *row;
}

double StudyReader::number(const std::string& key)
{
    const StudyKey& row = rowOf(key);
    return number(key, row.unit, row.displayUnit, row.minimum, row.maximum).value_or(std::get<double>(row.standard));
}

int StudyReader::integer(const std::string& key)
{
    const StudyKey& row = rowOf(key);
    return integer(key, static_cast<int>(row.minimum), static_cast<int>(row.maximum))
        .value_or(std::get<int>(row.standard));
}

bool StudyReader::flag(const std::string& key) { return boolean(key).value_or(std::get<bool>(rowOf(key).standard)); }

std::string StudyReader::choice(const std::string& key)
{
    const StudyKey& row = rowOf(key);
    return choice(key, row.choices).value_or(std::get<std::string>(row.standard));
}

std::optional<double> StudyReader::number(const std::string& key, const std::string& unit,
                                          const std::string& displayUnit, double minimum, double maximum)
{
    const TomlEntry* entry = find(key);
    if (entry == nullptr) return {};
    return inRange(key, entry->value, unit, displayUnit, minimum, maximum);
}

std::optional<int> StudyReader::integer(const std::string& key, int minimum, int maximum)
{
    const TomlEntry* entry = find(key);
    if (entry == nullptr) return {};
    const auto* value = std::get_if<std::int64_t>(&entry->value);
    if (value != nullptr && *value >= minimum && *value <= maximum) return static_cast<int>(*value);
    add(key, "must be " + wholeRangeText(minimum, maximum));
    return {};
}

std::optional<bool> StudyReader::boolean(const std::string& key)
{
    const TomlEntry* entry = find(key);
    if (entry == nullptr) return {};
    if (const auto* value = std::get_if<bool>(&entry->value)) return *value;
    add(key, "has the wrong type; true or false is needed");
    return {};
}

std::optional<std::string> StudyReader::text(const std::string& key, const std::string& needed)
{
    const TomlEntry* entry = find(key);
    if (entry == nullptr) return {};
    if (const auto* value = std::get_if<std::string>(&entry->value)) return *value;
    add(key, "has the wrong type; " + needed + " is needed");
    return {};
}

std::optional<std::string> StudyReader::choice(const std::string& key, const std::vector<std::string>& choices)
{
    const auto value = text(key);
    if (!value || std::ranges::find(choices, *value) != choices.end()) return value;
    add(key, inQuotes(*value) + " is not known: allowed is " + choiceText(choices) +
                 didYouMean(nearestName(*value, choices)));
    return {};
}

std::optional<std::vector<std::string>> StudyReader::texts(const std::string& key, const std::string& needed)
{
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
    add(key, faultOf(*entry) + needed + " is needed");
    return {};
}

std::optional<std::vector<double>> StudyReader::numbers(const std::string& key, const std::string& unit,
                                                        const std::string& displayUnit, double minimum, double maximum)
{
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
    add(key, faultOf(*entry) + "a list such as [" + one + ", " + one + "] is needed");
    return {};
}

std::vector<CaseSetting> StudyReader::settings(const std::string& table)
{
    std::vector<CaseSetting> list;
    settled_.insert(table);
    if (entries_.contains(table) || (findTable(table) != nullptr && findTable(table)->kind == TomlTableKind::Array))
        add(table, std::string("must be ") + neededSettings);
    for (const TomlEntry& entry : toml_.entries) {
        if (!entry.key.starts_with(table + '.')) continue;
        if (auto value = settingText(entry.value))
            list.push_back({settingKey(entry.key, table), std::move(*value)});
        else
            addAt(entry.line, entry.key,
                  "has the wrong type; a text, a number, true, false or a list of these is needed");
    }
    return list;
}

void StudyReader::addOfSettings(const std::string& owner, const std::vector<std::string>& tables,
                                const InputProblem& problem)
{
    for (const std::string& table : tables)
        for (const TomlEntry& entry : toml_.entries)
            if (entry.key.starts_with(table + '.') && settingKey(entry.key, table) == problem.key)
                return addAt(entry.line, entry.key, problem.message);
    add(owner, problem.text());
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
    for (const auto* names : {&asked_, &known_})
        for (const std::string& key : *names)
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
    const auto begins = [](const std::set<std::string>& names, const std::string& prefix) {
        const auto first = names.lower_bound(prefix);
        return first != names.end() && first->starts_with(prefix);
    };
    const auto isKnown = [&](const std::string& key) {
        return asked_.contains(key) || known_.contains(withoutNumbers(key));
    };
    const auto isTable = [&](const std::string& key) { return begins(asked_, key + '.') || begins(known_, key + '.'); };
    for (const TomlTable& table : toml_.tables) {
        if (inside(table.key) || isKnown(table.key) || isTable(table.key) || begins(asked_, table.key + '[')) continue;
        done.insert(table.key);
        addAt(table.line, table.key, "unknown table" + suggestion(table.key));
    }
    for (const TomlEntry& entry : toml_.entries) {
        if (inside(entry.key)) continue;
        if (!isKnown(entry.key))
            addAt(entry.line, entry.key, "unknown key" + suggestion(entry.key));
        else if (isTable(entry.key))
            addAt(entry.line, entry.key, "is a table, not a value; write [" + entry.key + "]");
    }
}

/// A value; where a table stands instead, that is reported once.
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
    InputProblem problem{option ? "--option" : name_, option ? 0 : line, shortenedKey(key), std::move(message)};
    // A key may be read more than once.
    if (told_.insert(std::to_string(line) + ' ' + problem.text()).second) problems_.push_back(std::move(problem));
}

} // namespace touchdown
