// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/design_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/simulation/case_reader.h"
#include "core/simulation/decimal.h"
#include "core/simulation/nearest_name.h"
#include "core/simulation/quotation.h"
#include "core/simulation/steady_quantities.h"
#include "core/simulation/text_file.h"
#include "core/simulation/toml_document.h"
#include "core/simulation/toml_quantity.h"

namespace touchdown {

namespace {

constexpr std::uintmax_t largestFile = 1 << 20; // [byte]
constexpr int mostIterations = 1000;
constexpr double smallestDifference = 1e-6, largestDifference = 0.25;

/// The quantities that may be wanted; an error of the grid is none.
std::vector<Quantity> wantedQuantities()
{
    std::vector<Quantity> list;
    for (const SteadyQuantity& each : steadyQuantities({}))
        if (!each.quantity.name.ends_with("_error")) list.push_back(each.quantity);
    return list;
}

/// Twelve digits: differences of lengths carry the rounding of their ends.
double withoutNoise(double value)
{
    if (value == 0.0) return value;
    const double scale = std::pow(10.0, 11.0 - std::floor(std::log10(std::abs(value))));
    return std::round(value * scale) / scale;
}

class DesignReader {
public:
    DesignReader(DesignDocument& document, const TomlDocument& toml) : document_(document), toml_(toml) {}

    void read(const std::filesystem::path& folder, const std::vector<std::string>& settings)
    {
        for (const TomlEntry& entry : toml_.entries) entries_[entry.key] = &entry;
        lookForStrangers();
        readSearch();
        openStart(folder, settings);
        if (document_.valid()) readParameters();
        readTargets();
        std::ranges::stable_sort(document_.problems, {}, &InputProblem::line);
    }

private:
    struct Place {
        std::string table; // "parameter[1]"
        int line = 0;
    };

    void add(int line, const std::string& key, std::string message)
    {
        document_.problems.push_back({document_.name, line, shortenedKey(key), std::move(message)});
    }

    const TomlEntry* find(const std::string& key) const
    {
        const auto found = entries_.find(key);
        return found == entries_.end() ? nullptr : found->second;
    }

    void lookForStrangers()
    {
        for (const TomlTable& table : toml_.tables) {
            const std::string kind = table.key.substr(0, table.key.find('['));
            const bool list = kind == "parameter" || kind == "target";
            if (table.key == kind && list && table.kind != TomlTableKind::Array)
                add(table.line, table.key, "is one of a list; write [[" + kind + "]]");
            else if (!list && table.key != "search")
                add(table.line, table.key,
                    "unknown table" + didYouMean(nearestName(kind, {"parameter", "target", "search"})));
        }
        for (const TomlEntry& entry : toml_.entries) {
            const auto dot = entry.key.find_last_of('.');
            const std::string table = dot == std::string::npos ? "" : entry.key.substr(0, dot);
            const std::string leaf = entry.key.substr(dot + 1);
            const std::vector<std::string> names = namesIn(table.substr(0, table.find('[')));
            if (names.empty() || std::ranges::find(names, leaf) != names.end()) continue;
            add(entry.line, entry.key, "unknown key" + didYouMean(nearestName(leaf, names)));
        }
    }

    static std::vector<std::string> namesIn(const std::string& table)
    {
        if (table.empty()) return {"case", "title"};
        if (table == "parameter") return {"key", "keys", "start", "minimum", "maximum"};
        if (table == "target") return {"quantity", "value", "tolerance"};
        if (table == "search") return {"iterations", "difference"};
        return {}; // the table itself has been named
    }

    std::optional<std::string> text(const std::string& key, int line, const std::string& example)
    {
        const TomlEntry* entry = find(key);
        const auto* value = entry == nullptr ? nullptr : std::get_if<std::string>(&entry->value);
        if (value != nullptr) return *value;
        add(entry == nullptr ? line : entry->line, key,
            (entry == nullptr ? "is missing; " : "has the wrong type; ") + example + " is needed");
        return {};
    }

    /// A missing one is a problem unless there is a number to stand for it.
    std::optional<double> number(const std::string& key, int line, const std::string& unit,
                                 const std::string& displayUnit, std::optional<double> otherwise = {})
    {
        const TomlEntry* entry = find(key);
        if (entry == nullptr) {
            if (!otherwise) add(line, key, "is missing");
            return otherwise;
        }
        const auto value = tomlQuantity(entry->value, unit, displayUnit);
        if (const auto* problem = std::get_if<UnitProblem>(&value)) {
            add(entry->line, key, problem->message);
            return {};
        }
        return std::get<double>(value);
    }

    int lineOf(const std::string& key, int line) const
    {
        const TomlEntry* entry = find(key);
        return entry == nullptr ? line : entry->line;
    }

    void readSearch()
    {
        if (const TomlEntry* entry = find("search.iterations")) {
            const auto* value = std::get_if<std::int64_t>(&entry->value);
            if (value == nullptr || *value < 1 || *value > mostIterations)
                add(entry->line, entry->key, "must be a whole number from 1 to " + std::to_string(mostIterations));
            else
                document_.task.maximumIterations = static_cast<int>(*value);
        }
        if (const auto share = number("search.difference", 0, "", "", document_.task.difference)) {
            if (*share < smallestDifference || *share > largestDifference)
                add(lineOf("search.difference", 0), "search.difference",
                    "must be from " + decimalText(smallestDifference) + " to " + decimalText(largestDifference));
            document_.task.difference = *share;
        }
    }

    void openStart(const std::filesystem::path& folder, const std::vector<std::string>& settings)
    {
        const auto name = text("case", 0, "the file of a case, or the name of a sample case, in quotation marks");
        if (!name) return;
        std::error_code none;
        const std::filesystem::path beside = folder / *name;
        CaseDocument& start = document_.start;
        start = openCase(std::filesystem::exists(beside, none) ? beside.string() : *name);
        if (!settings.empty()) applySettings(start, settings);
        for (const InputProblem& problem : start.problems) document_.problems.push_back(problem);
        if (!start.valid()) return;
        if (const std::string reason = reasonNotToDesign(start.value); !reason.empty())
            add(lineOf("case", 0), "case", start.name + ": " + reason);
    }

    std::vector<Place> places(const std::string& kind, std::size_t most)
    {
        std::vector<Place> list;
        for (const TomlTable& table : toml_.tables)
            if (table.key.starts_with(kind + '[') && table.key.ends_with(']')) list.push_back({table.key, table.line});
        if (list.empty()) add(0, kind, "a study needs one or more; write [[" + kind + "]] for each");
        if (list.size() > most) {
            add(list[most].line, kind,
                std::to_string(list.size()) + " are too many; at most " + std::to_string(most) + " are possible");
            list.clear();
        }
        return list;
    }

    std::vector<std::string> keysOf(const Place& place)
    {
        const TomlEntry* list = find(place.table + ".keys");
        const TomlEntry* one = find(place.table + ".key");
        if (list == nullptr) {
            const auto key = text(place.table + ".key", place.line, "a key of the case in quotation marks");
            return key ? std::vector{*key} : std::vector<std::string>{};
        }
        std::vector<std::string> keys;
        const auto* array = std::get_if<TomlArray>(&list->value);
        for (const TomlElement& element : array == nullptr ? std::vector<TomlElement>{} : array->elements)
            if (const auto* key = std::get_if<std::string>(&element.value)) keys.push_back(*key);
        if (one != nullptr)
            add(one->line, one->key, "is one key, and keys are several; write one of the two");
        else if (array == nullptr || keys.empty() || keys.size() != array->elements.size())
            add(list->line, list->key, "a list such as [\"abs.rail[1].recess\", \"abs.rail[3].recess\"] is needed");
        else
            return keys;
        return {};
    }

    void readParameters()
    {
        std::set<std::string> keys;
        for (const Place& place : places("parameter", mostParameters)) {
            const std::size_t before = document_.problems.size();
            DesignParameter parameter;
            for (const std::string& name : keysOf(place)) {
                auto key = designKey(document_.start.value, name);
                const std::string at = place.table + (find(place.table + ".keys") != nullptr ? ".keys" : ".key");
                if (!keys.insert(name).second)
                    add(lineOf(at, place.line), at, inQuotes(name) + " is changed by more than one parameter");
                else if (const auto* problem = std::get_if<std::string>(&key))
                    add(lineOf(at, place.line), at, inQuotes(name) + ' ' + *problem);
                else if (parameter.keys.push_back(std::get<DesignKey>(key));
                         parameter.keys.back().unit != parameter.keys.front().unit)
                    add(lineOf(at, place.line), at, inQuotes(name) + " is measured otherwise than the first key");
            }
            if (document_.problems.size() != before) continue;
            readBounds(place, parameter);
            if (document_.problems.size() == before) document_.task.parameters.push_back(std::move(parameter));
        }
    }

    void readBounds(const Place& place, DesignParameter& parameter)
    {
        const DesignKey& first = parameter.keys.front();
        const auto value = [&](const char* name, std::optional<double> otherwise = {}) {
            return number(place.table + '.' + name, place.line, first.unit, first.displayUnit, otherwise);
        };
        const auto minimum = value("minimum"), maximum = value("maximum"),
                   start = value("start", first.get(document_.start.value));
        if (!minimum || !maximum || !start) return;
        parameter.minimum = *minimum;
        parameter.maximum = *maximum;
        parameter.start = *start;
        const auto shown = [&](double number) { return formatQuantity(withoutNoise(number), first.displayUnit); };
        const auto complain = [&](const char* name, std::string message) {
            const std::string key = place.table + '.' + name;
            add(lineOf(key, place.line), key, std::move(message));
        };
        if (!(*minimum < *maximum))
            return complain("maximum", "must be greater than minimum (" + shown(*minimum) + ")");
        if (*start < *minimum || *start > *maximum)
            return complain("start", shown(*start) + " is not between minimum (" + shown(*minimum) + ") and maximum (" +
                                         shown(*maximum) + ")");
        for (const auto& [name, bound] : {std::pair{"minimum", *minimum}, std::pair{"maximum", *maximum}}) {
            Case tried = document_.start.value;
            for (const DesignKey& key : parameter.keys)
                if (const auto problem = key.set(tried, key.get(tried) + bound - first.get(document_.start.value)))
                    return complain(name, key.key + ": " + *problem);
        }
    }

    void readTargets()
    {
        const std::vector<Quantity> quantities = wantedQuantities();
        std::vector<std::string> names;
        for (const Quantity& quantity : quantities) names.push_back(quantity.name);
        for (const Place& place : places("target", mostTargets)) {
            const auto name = text(place.table + ".quantity", place.line, "a quantity such as \"minimum_spacing\"");
            if (!name) continue;
            const int index = findQuantity(quantities, *name);
            if (index < 0) {
                const std::string key = place.table + ".quantity";
                add(lineOf(key, place.line), key,
                    inQuotes(*name) + " is no quantity of a static state" + didYouMean(nearestName(*name, names)));
                continue;
            }
            const Quantity& quantity = quantities[static_cast<std::size_t>(index)];
            const auto value = number(place.table + ".value", place.line, quantity.unit, quantity.displayUnit);
            const auto tolerance = number(place.table + ".tolerance", place.line, quantity.unit, quantity.displayUnit);
            if (tolerance && !(*tolerance > 0.0))
                add(lineOf(place.table + ".tolerance", place.line), place.table + ".tolerance",
                    "must be greater than 0");
            else if (value && tolerance)
                document_.task.targets.push_back({quantity, *value, *tolerance});
        }
    }

    DesignDocument& document_;
    const TomlDocument& toml_;
    std::map<std::string, const TomlEntry*, std::less<>> entries_;
};

} // namespace

DesignDocument parseDesign(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                           const std::vector<std::string>& settings)
{
    DesignDocument document;
    document.name = name;
    const TomlDocument toml = readToml(text);
    if (!toml.problem.empty())
        document.problems.push_back({name, toml.problemLine, "", toml.problem});
    else
        DesignReader(document, toml).read(folder, settings);
    return document;
}

DesignDocument readDesign(const std::filesystem::path& file, const std::vector<std::string>& settings)
{
    const auto content = readTextFile(file, largestFile);
    if (const auto* problem = std::get_if<FileProblem>(&content)) {
        DesignDocument document;
        document.name = file.string();
        document.problems.push_back({document.name, 0, "", problem->message});
        return document;
    }
    return parseDesign(std::get<std::string>(content), file.string(), file.parent_path(), settings);
}

std::string writeDesignCsv(const std::filesystem::path& file, const DesignTask& task, const DesignStudy& study)
{
    std::string text = "iteration";
    for (const DesignParameter& parameter : task.parameters) {
        const DesignKey& key = parameter.keys.front();
        text += ',' + key.key + (key.unit.empty() ? "" : " [" + key.unit + ']');
    }
    for (const DesignTarget& target : task.targets)
        text += ',' + target.quantity.name + " [" + target.quantity.unit + ']';
    text += ",misfit\r\n";
    for (const DesignPoint& point : study.steps) {
        text += std::to_string(point.iteration);
        for (const double value : point.parameters) text += ',' + decimalText(value);
        for (const double value : point.quantities) text += ',' + decimalText(value);
        text += ',' + decimalText(point.misfit) + "\r\n";
    }
    const std::string problem = writeTextFile(file, text);
    return problem.empty() ? problem : file.string() + ": " + problem;
}

} // namespace touchdown
