// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/surface_tables.h"

#include "core/formats/nearest_name.h"
#include "core/formats/toml_quantity.h"
#include "core/formats/words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace touchdown {

std::optional<TablePlace> tablePlace(std::string_view key, std::string_view kind)
{
    if (!key.starts_with(kind) || key.size() == kind.size() || key[kind.size()] != '[') return {};
    const std::size_t close = key.find(']', kind.size());
    if (close == std::string_view::npos) return {};
    TablePlace place{0, key.substr(close + 1)};
    std::from_chars(key.data() + kind.size() + 1, key.data() + close, place.number);
    if (place.leaf.starts_with('.')) place.leaf.remove_prefix(1);
    return place;
}

void SurfaceTables::add(int line, std::string_view key, std::string message)
{
    problems_.push_back({"", line, std::string(key), std::move(message)});
}

std::optional<std::size_t> SurfaceTables::countTables(std::string_view kind, std::string_view name, std::size_t most,
                                                      bool& mentioned)
{
    std::size_t count = 0;
    for (const TomlTable& table : toml_.tables) {
        if (table.key == kind) {
            mentioned = true;
            if (table.kind != TomlTableKind::Array) {
                add(table.line, kind,
                    "is one table; write [[" + std::string(kind) + "]] for each " + std::string(name));
                return {};
            }
        } else if (const auto place = tablePlace(table.key, kind)) {
            if (place->leaf.empty())
                count = std::max(count, place->number);
            else if (place->leaf.find('.') == std::string_view::npos)
                add(table.line, table.key, "unknown table");
        }
    }
    for (const TomlEntry& entry : toml_.entries) {
        if (entry.key != kind) continue;
        const auto* array = std::get_if<TomlArray>(&entry.value);
        if (array == nullptr || !array->elements.empty()) {
            add(entry.line, kind, "is not a table; write [[" + std::string(kind) + "]] for each " + std::string(name));
            return {};
        }
        mentioned = true;
    }
    if (count <= most) return count;
    add(0, kind, counted(count, name) + " are too many; at most " + std::to_string(most) + " are possible");
    return {};
}

void SurfaceTables::unknown(const TomlEntry& entry, const TablePlace& place, const std::vector<std::string>& names)
{
    if (place.leaf.find('.') == std::string_view::npos) // else its table has been named
        add(entry.line, entry.key, "unknown key" + didYouMean(nearestName(place.leaf, names)));
}

std::optional<double> SurfaceTables::length(const TomlValue& value, int line, const std::string& key, const char* unit)
{
    constexpr double farthest = 1.0; // of any length [m]
    const auto number = tomlQuantity(value, "m", unit);
    if (const auto* problem = std::get_if<UnitProblem>(&number)) {
        add(line, key, problem->message);
        return {};
    }
    const double metres = std::get<double>(number) + 0.0;
    if (std::abs(metres) <= farthest) return metres;
    add(line, key,
        formatQuantity(metres, "m") + " is out of range: allowed is at most " + formatQuantity(farthest, "m"));
    return {};
}

std::string SurfaceTables::numbered(std::string_view kind, std::size_t number)
{
    return std::string(kind) + '[' + std::to_string(number) + ']';
}

const TomlTable* SurfaceTables::tableOf(std::string_view kind, std::size_t number) const
{
    const auto found = std::ranges::find(toml_.tables, numbered(kind, number), &TomlTable::key);
    return found == toml_.tables.end() ? nullptr : &*found;
}

bool SurfaceTables::wrong(std::string_view key) const
{
    return std::ranges::find(problems_, key, &InputProblem::key) != problems_.end();
}

} // namespace touchdown
