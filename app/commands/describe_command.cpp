// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/describe_command.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>
#include <vector>

#include "app/commands/describe_readings.h"
#include "app/commands/study_command.h"
#include "app/terminal/console.h"
#include "app/terminal/json_text.h"
#include "app/terminal/refusal.h"
#include "app/terminal/report_text.h"
#include "app/terminal/text_table.h"
#include "core/case/case_key.h"
#include "core/case/parameters.h"
#include "core/case_files/surface_text.h"
#include "core/formats/nearest_name.h"
#include "core/formats/words.h"
#include "core/studies/study_plan.h"

namespace touchdown {

namespace {

using Selection = std::vector<const Parameter*>;

std::string kindName(const Parameter& parameter)
{
    switch (parameter.kind) {
    case ParameterKind::Number: return "number";
    case ParameterKind::Integer: return "integer";
    case ParameterKind::Choice: return "choice";
    case ParameterKind::Boolean: return "boolean";
    case ParameterKind::Text: return "text";
    case ParameterKind::List: return "list";
    }
    return {};
}

Selection select(const std::string& key)
{
    Selection selection;
    for (const Parameter& parameter : parameters())
        if (key.empty() || parameter.key == key || parameter.group() == key) selection.push_back(&parameter);
    return selection;
}

/// The key, group or kind of study that is most like this one.
std::string nearest(const std::string& key)
{
    if (const std::string name = nearestKey(key); !name.empty()) return name;
    std::vector<std::string> groups;
    for (const Parameter& parameter : parameters())
        if (!parameter.group().empty() && (groups.empty() || groups.back() != parameter.group()))
            groups.push_back(parameter.group());
    std::ranges::copy(studyKindNames(), std::back_inserter(groups));
    return nearestName(key, groups);
}

std::string defaultText(const Parameter& parameter)
{
    const auto shown = [&](ModelKind model) {
        const std::string text = toText(defaultsOf(model), parameter);
        return text.empty() ? "(empty)" : text;
    };
    std::string text = shown(ModelKind::Springs);
    // The model has one default.
    if (parameter.key == "model") return text;
    const auto add = [&, springs = text](const char* name, ModelKind model) {
        if (const std::string other = shown(model); other != springs) text += std::string("; ") + name + ": " + other;
    };
    add("film", ModelKind::Film);
    add("contact", ModelKind::Contact);
    return text;
}

std::string unitText(const Parameter& parameter)
{
    const bool numbers = parameter.kind == ParameterKind::Number || parameter.kind == ParameterKind::List;
    if (parameter.unit.empty()) return numbers ? "-" : "";
    return parameter.unit == parameter.displayUnit ? parameter.unit
                                                   : parameter.displayUnit + " (" + parameter.unit + ")";
}

/// Each number of rails, walls and points of interest.
std::string surfaceText()
{
    std::string text =
        wrapped(std::string(surfaceHelp()), 0) + "\n" +
        wrapped("Each of their numbers has a key for --set, for designs and for studies; all are lengths "
                "but the wall of an edge. N and K count from 1.",
                0) +
        "\n";
    std::size_t width = 0;
    for (const SurfaceNumberForm& form : surfaceNumberForms()) width = std::max(width, form.key.size());
    for (const SurfaceNumberForm& form : surfaceNumberForms()) text += padded(form.key, width) + form.help + "\n";
    return text;
}

Json surfaceJson()
{
    Json all = Json::array();
    for (const SurfaceNumberForm& form : surfaceNumberForms()) all.push_back({{"key", form.key}, {"help", form.help}});
    return all;
}

std::string table(const Selection& selection)
{
    std::size_t keyWidth = 3;
    std::size_t unitWidth = 4;
    std::size_t defaultWidth = 7;
    for (const Parameter* parameter : selection) {
        keyWidth = std::max(keyWidth, parameter->key.size());
        unitWidth = std::max(unitWidth, unitText(*parameter).size());
        defaultWidth = std::max(defaultWidth, defaultText(*parameter).size());
    }
    std::string text =
        padded("KEY", keyWidth) + padded("UNIT", unitWidth) + padded("DEFAULT", defaultWidth) + "ALLOWED\n";
    std::string group;
    for (std::size_t i = 0; i < selection.size(); ++i) {
        const Parameter* parameter = selection[i];
        if (parameter->group() != group) text += "\n[" + parameter->group() + "]\n";
        group = parameter->group();
        text += padded(parameter->key, keyWidth) + padded(unitText(*parameter), unitWidth) +
                padded(defaultText(*parameter), defaultWidth) + allowedRange(*parameter) + "\n";
        text += wrapped(parameter->help + (parameter->source.empty() ? "" : " Source: " + parameter->source + "."), 6);
        const bool last = i + 1 == selection.size() || selection[i + 1]->group() != group;
        if (group == "abs" && last && selection.size() > 1) text += wrapped(std::string(surfaceHelp()), 6);
    }
    return text;
}

std::string details(const Parameter& parameter)
{
    const auto line = [](const char* name, const std::string& value) {
        return value.empty() ? std::string() : padded(name, 8) + value + "\n";
    };
    return line("key", parameter.key) + line("name", parameter.label) + line("symbol", parameter.symbol) +
           line("kind", kindName(parameter)) + line("unit", unitText(parameter)) +
           line("default", defaultText(parameter)) + line("allowed", allowedRange(parameter)) +
           line("effect", parameter.help) + line("source", parameter.source);
}

Json json(const Parameter& parameter)
{
    const auto value = [](const ParameterValue& v) { return std::visit([](const auto& x) { return Json(x); }, v); };
    Json result{{"key", parameter.key},
                {"label", parameter.label},
                {"symbol", parameter.symbol},
                {"kind", kindName(parameter)}};
    const bool list = parameter.kind == ParameterKind::List;
    if (parameter.kind == ParameterKind::Number || list) {
        result["unit"] = parameter.unit.empty() ? "1" : parameter.unit;
        result["display_unit"] = parameter.displayUnit;
    }
    if (list) result["minimum_count"] = parameter.minimumCount;
    if (list) result["maximum_count"] = parameter.maximumCount;
    if (parameter.kind == ParameterKind::Number || parameter.kind == ParameterKind::Integer || list) {
        result["minimum"] = jsonNumber(parameter.minimum);
        result["minimum_allowed"] = parameter.minimumAllowed;
        result["maximum"] = jsonNumber(parameter.maximum);
    }
    if (parameter.kind == ParameterKind::Choice) result["choices"] = parameter.choices;
    result["default"] = value(parameter.get(Case{}));
    result["allowed"] = allowedRange(parameter);
    result["help"] = parameter.help;
    result["source"] = parameter.source;
    return result;
}

/// "5; film: 3".
std::string standardText(const DescribedKey& key)
{
    std::string text;
    for (const auto& [model, value] : key.standards) {
        if (text.empty())
            text = value;
        else if (value != key.standards.front().second)
            text += "; " + model + ": " + value;
    }
    return text;
}

std::string keyText(const DescribedKey& key, std::size_t width)
{
    const std::string standard = standardText(key);
    const std::string allowed = wrapped(key.allowed + (key.varies ? ", by the case" : ""), width + 2).substr(width + 2);
    std::string more = key.key.help;
    if (!more.empty())
        more = static_cast<char>(std::toupper(static_cast<unsigned char>(more.front()))) + more.substr(1) + ". ";
    if (!standard.empty()) more += "Default: " + standard + ".";
    return padded(key.key.key, width) + allowed + (more.empty() ? "" : wrapped(more, 6));
}

std::string keysText(const std::vector<DescribedKey>& keys)
{
    std::size_t width = 3;
    for (const DescribedKey& each : keys) width = std::max(width, each.key.key.size());
    std::string text = padded("KEY", width) + "ALLOWED\n", table;
    for (const DescribedKey& each : keys) {
        const std::string& key = each.key.key;
        const auto dot = key.find('.');
        const std::string its = dot == std::string::npos ? "" : key.substr(0, dot);
        if (its != table) text += each.key.inList ? "\n[[" + its + "]], any number of them\n" : "\n[" + its + "]\n";
        table = its;
        text += keyText(each, width);
    }
    return text;
}

Json keysJson(const std::vector<DescribedKey>& keys)
{
    Json all = Json::array();
    for (const DescribedKey& each : keys) {
        Json standards = Json::object();
        for (const auto& [model, value] : each.standards) standards[model] = value;
        all.push_back({{"key", each.key.key},
                       {"allowed", each.allowed},
                       {"varies", each.varies},
                       {"unit", each.key.unit},
                       {"display_unit", each.key.displayUnit},
                       {"default", standards},
                       {"help", each.key.help}});
    }
    return all;
}

int describeKinds(bool json)
{
    Json all = Json::array();
    std::vector<std::vector<std::string>> rows;
    for (const StudyKind& kind : studyKinds()) {
        all.push_back({{"name", kind.name}, {"title", kind.title}, {"help", kind.help}});
        rows.push_back({kind.name, kind.title});
    }
    print(json ? jsonText({{"kinds", all}})
               : alignedTable(rows, {true, true}) + "\n`touchdown describe study.KIND` lists the keys of one.\n");
    return exitDone;
}

int describeKind(const StudyKind& kind, const std::string& wanted, bool json)
{
    std::vector<DescribedKey> keys = studyKeys(kind.name);
    std::vector<std::string> names;
    for (const DescribedKey& each : keys) names.push_back(each.key.key);
    if (!wanted.empty())
        std::erase_if(keys, [&](const DescribedKey& each) {
            return each.key.key != wanted && !each.key.key.starts_with(wanted + '.');
        });
    if (keys.empty()) {
        const std::string message = "unknown key of a study of kind " + kind.name;
        return refuse({{"", 0, wanted, message + didYouMean(nearestName(wanted, names))}}, json);
    }
    if (json) {
        print(jsonText({{"kind", kind.name}, {"keys", keysJson(keys)}}));
        return exitDone;
    }
    const std::string command = kind.name == "advise" ? "advise" : "study " + kind.name;
    print(wrapped(kind.title + ". " + kind.help + ". The keys of its file, and of --option; `touchdown " + command +
                      " CASE --template` prints a file to begin with.",
                  0) +
          "\n" + keysText(keys));
    return exitDone;
}

/// Describes "study", "study.KIND" or "KIND", or a key below it, and returns the exit code; nothing for any other key.
std::optional<int> describeStudy(const std::string& key, bool json)
{
    constexpr std::string_view prefix = "study.";
    if (key == "study") return describeKinds(json);
    const std::string name = key.starts_with(prefix) ? key.substr(prefix.size()) : key;
    if (name == "sweep.readings" || name == "readings") return describeReadings(json);
    for (const StudyKind& kind : studyKinds()) {
        if (name == kind.name) return describeKind(kind, {}, json);
        if (name.starts_with(kind.name + '.')) return describeKind(kind, name.substr(kind.name.size() + 1), json);
    }
    if (!key.starts_with(prefix)) return {};
    const std::vector<std::string> kinds = studyKindNames();
    const std::string message = "unknown kind of study: allowed is one of " + joined(kinds);
    return refuse({{"", 0, key, message + didYouMean(nearestName(name, kinds))}}, json);
}

} // namespace

int describeCommand(const std::string& key, bool asJson)
{
    const Selection selection = select(key);
    if (isSurfaceKey(key) || key == railFileKey || key.starts_with("abs.points_of_interest")) {
        print(asJson ? jsonText(
                           {{"fields", Json::array()}, {"surface", surfaceHelp()}, {"surface_numbers", surfaceJson()}})
                     : surfaceText());
        return exitDone;
    }
    if (selection.empty()) {
        if (const auto code = describeStudy(key, asJson)) return *code;
        return refuse({{"", 0, key, "unknown key" + didYouMean(nearest(key))}}, asJson);
    }
    if (asJson) {
        Json all = Json::array();
        for (const Parameter* parameter : selection) all.push_back(json(*parameter));
        Json result{{"fields", all}};
        if (key.empty() || key == "abs") {
            result["surface"] = surfaceHelp();
            result["surface_numbers"] = surfaceJson();
        }
        print(jsonText(result));
    } else {
        print(selection.size() == 1 && selection.front()->key == key ? details(*selection.front()) : table(selection));
    }
    return exitDone;
}

} // namespace touchdown
