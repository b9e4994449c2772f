// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_form_fields.h"

#include <algorithm>
#include <map>
#include <variant>

#include <QRegularExpression>

#include "core/case/case_key.h"
#include "core/case/parameters.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "ui/case/parameter_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"
#include "ui/style/translate.h"
#include "ui/style/window_words.h"

namespace touchdown {

namespace {

constexpr std::size_t mostCells = 150; // of a list in the form

bool hasTable(const TomlDocument& toml, const std::string& key)
{
    return std::ranges::any_of(toml.tables, [&key](const TomlTable& table) { return table.key == key; });
}

std::string textAt(const TomlDocument& toml, const std::string& key)
{
    const TomlEntry* entry = entryOf(toml, key);
    const auto* text = entry == nullptr ? nullptr : std::get_if<std::string>(&entry->value);
    return text == nullptr ? std::string() : *text;
}

std::string oneOf(const std::string& list, std::size_t number) { return list + '[' + std::to_string(number) + ']'; }

const Quantity* staticQuantity(const std::string& name)
{
    static const std::vector<SteadyQuantity> all = steadyQuantities({});
    const auto found = std::ranges::find(all, name, [](const SteadyQuantity& each) { return each.quantity.name; });
    return found == all.end() ? nullptr : &found->quantity;
}

/// Of the quantity or the number of the case that a table names; empty if it names none.
std::string unitOfTable(const TomlDocument& toml, const std::string& table, const Case& c)
{
    if (const Quantity* quantity = staticQuantity(textAt(toml, table + ".quantity"))) return quantity->displayUnit;
    std::string key = textAt(toml, table + ".key");
    if (const TomlEntry* several = entryOf(toml, table + ".keys"); several != nullptr)
        if (const auto* array = std::get_if<TomlArray>(&several->value); array != nullptr && !array->elements.empty())
            if (const auto* first = std::get_if<std::string>(&array->elements.front().value)) key = *first;
    const auto number = numberKey(c, key);
    const auto* parameter = std::get_if<Parameter>(&number);
    return parameter == nullptr ? std::string() : parameter->displayUnit;
}

/// A table has a key or its plural: "keys" instead of "key".
bool isShownCell(const StudyKey& key, const std::string& table, const TomlDocument& toml,
                 const std::vector<StudyKey>& all)
{
    if (key.kind == StudyKeyKind::Settings) return false;
    const auto isKnown = [&](const std::string& name) {
        return std::ranges::any_of(all, [&](const StudyKey& each) { return each.key == name; });
    };
    const bool isPlural = key.key.ends_with('s') && isKnown(key.key.substr(0, key.key.size() - 1));
    if (isPlural) return entryOf(toml, table + '.' + leafOf(key.key)) != nullptr;
    return !isKnown(key.key + 's') || entryOf(toml, table + '.' + leafOf(key.key)) != nullptr ||
           entryOf(toml, table + '.' + leafOf(key.key) + 's') == nullptr;
}

void addRows(FormFields& fields, FormList list, const StudyForm& form, const TomlDocument& toml, const Case& c)
{
    std::vector<StudyKey> keys;
    for (const StudyKey& key : form.keys)
        if (key.inList && ownerOf(key.key) == list.name) keys.push_back(key);
    std::size_t count = 0;
    for (; hasTable(toml, oneOf(list.name, count + 1)); ++count)
        list.onlyText |=
            std::ranges::find(toml.tables, oneOf(list.name, count + 1), &TomlTable::key)->kind != TomlTableKind::Header;
    list.onlyText |= count * keys.size() > mostCells;
    list.rows = list.onlyText ? 0 : count;
    for (std::size_t number = 1; number <= list.rows; ++number) {
        const std::string table = oneOf(list.name, number), unit = unitOfTable(toml, table, c);
        for (const StudyKey& key : keys) {
            if (!isShownCell(key, table, toml, keys)) continue;
            StudyKey& cell = fields.cells.emplace_back(key);
            cell.key = table + '.' + leafOf(key.key);
            if (cell.kind == StudyKeyKind::Number && cell.displayUnit.empty()) cell.displayUnit = unit;
        }
    }
    fields.lists.push_back(std::move(list));
}

/// Whether the text has one of the lists that the form would write.
bool namesList(const TomlDocument& toml, const TomlDocument& standard)
{
    return std::ranges::any_of(standard.tables, [&](const TomlTable& table) { return hasTable(toml, table.key); });
}

} // namespace

FormFields fieldsOf(const StudyForm& form, const TomlDocument& toml, const Case& c)
{
    FormFields fields;
    for (const StudyKey& key : form.keys) {
        const std::string table = ownerOf(key.key);
        if (key.inList) {
            if (std::ranges::find(fields.lists, table, &FormList::name) != fields.lists.end()) continue;
            const TomlDocument standard = readToml(form.lists);
            const bool areDefaults = !namesList(toml, standard) && hasTable(standard, table);
            addRows(fields, {.name = table, .areDefaults = areDefaults}, form, areDefaults ? standard : toml, c);
            continue;
        }
        // A choice without a default has none for the model of this case.
        if (key.kind == StudyKeyKind::Choice && defaultText(key).empty() && entryOf(toml, key.key) == nullptr) continue;
        const bool shown = key.kind != StudyKeyKind::Settings && key.kind != StudyKeyKind::Table && key.key != "kind" &&
                           key.key != "title" && (table.empty() || hasTable(toml, table));
        if (shown) fields.keys.push_back(key);
    }
    return fields;
}

TomlDocument withDefaultLists(TomlDocument toml, const StudyForm& form)
{
    const TomlDocument standard = readToml(form.lists);
    if (namesList(toml, standard)) return toml;
    toml.entries.insert(toml.entries.end(), standard.entries.begin(), standard.entries.end());
    toml.tables.insert(toml.tables.end(), standard.tables.begin(), standard.tables.end());
    return toml;
}

const TomlEntry* entryOf(const TomlDocument& toml, const std::string& key)
{
    const auto found = std::ranges::find(toml.entries, key, &TomlEntry::key);
    return found == toml.entries.end() ? nullptr : &*found;
}

QString fieldLabel(const std::string& key)
{
    QString text = QString::fromStdString(key).replace(QLatin1Char('_'), QLatin1Char(' '));
    text.replace(QLatin1Char('.'), QStringLiteral(": "));
    text[0] = text[0].toUpper();
    return text;
}

QString columnLabel(const std::string& key)
{
    const std::string name = withoutNumbers(key);
    if (takesCaseKey(name)) return tr("Number");
    if (name == "parameter.minimum") return tr("From");
    if (name == "parameter.maximum") return tr("To");
    if (name == "target.value") return tr("Wanted");
    return fieldLabel(leafOf(name));
}

QString keyLabel(const std::string& key)
{
    const std::string name = withoutNumbers(key);
    for (const std::string table : {"set", "method.set"})
        if (name.starts_with(table + '.')) return labelOfKey(settingKey(name, table));
    if (const QString label = labelOfKey(key); !label.isEmpty()) return label;
    static const QRegularExpression number(QStringLiteral("\\[(\\d+)\\]"));
    return fieldLabel(QString::fromStdString(key).replace(number, QStringLiteral(" \\1")).toStdString());
}

bool takesCaseKey(const std::string& key)
{
    return key == "parameter" || key == "map.x" || key == "map.y" || key.ends_with(".key");
}

std::vector<std::pair<QString, std::string>> caseNumbers(const Case& c)
{
    std::vector<std::pair<QString, std::string>> all;
    const auto add = [&](const QString& label, const std::string& key) {
        if (std::holds_alternative<Parameter>(numberKey(c, key)))
            all.emplace_back(fieldLabel(label.toStdString()), key);
    };
    for (const Parameter& parameter : parameters()) add(readable(parameter.label), parameter.key);
    for (std::size_t rail = 1; rail <= c.surface.rails.size(); ++rail)
        for (const char* leaf : {"recess", "x", "y", "length", "width"})
            add(QStringLiteral("Rail %1: %2").arg(rail).arg(QLatin1String(leaf)),
                "abs.rail[" + std::to_string(rail) + "]." + leaf);
    std::map<QString, int> times;
    for (const auto& [label, key] : all) ++times[label];
    for (auto& [label, key] : all)
        if (times[label] > 1) label += QStringLiteral(" (%1)").arg(groupTitle(ownerOf(key)));
    return all;
}

QString quantityLabel(const std::string& name)
{
    const Quantity* quantity = staticQuantity(name);
    if (quantity == nullptr) return {};
    const QString label = readable(quantity->longName), unit = unitText(quantity->displayUnit);
    return unit.isEmpty() ? label : QStringLiteral("%1 (%2)").arg(label, unit);
}

} // namespace touchdown
