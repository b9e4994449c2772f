// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/swept_method.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "core/case/case_key.h"
#include "core/formats/quotation.h"
#include "core/formats/toml_document.h"
#include "core/formats/units.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

namespace {

constexpr int labelDigits = 6;

/// -1: smaller values are finer; 1: larger ones are; 0: they have no such order.
int finenessOf(std::string_view key)
{
    if (key.ends_with("step") || key.ends_with("tolerance") || key.ends_with("step_error") || key == "elastic.cell")
        return -1;
    return key == "film.nodes" ? 1 : 0;
}

/// "97, 97" of "97" for a list of two.
std::string fullValue(const Parameter& parameter, const std::string& value)
{
    if (parameter.kind != ParameterKind::List || parameter.minimumCount < 2 ||
        parameter.minimumCount != parameter.maximumCount)
        return value;
    if (listElements(value).size() != 1) return value;
    std::string list = value;
    for (std::size_t i = 1; i < parameter.minimumCount; ++i) list += ", " + value;
    return list;
}

/// "97" of "97, 97"; a number with no more figures than a person reads.
std::string labelOf(const Parameter& parameter, const Case& c)
{
    if (parameter.kind == ParameterKind::Number)
        return fewDigits(numberOf(parameter, c), parameter.displayUnit, labelDigits);
    const std::string value = toText(c, parameter);
    if (parameter.kind != ParameterKind::List) return value;
    const std::vector<std::string_view> elements = listElements(value);
    const bool alike = std::ranges::all_of(elements, [&](std::string_view each) { return each == elements.front(); });
    return elements.empty() || !alike ? value : std::string(elements.front());
}

/// values = [...], on as many lines as it takes.
std::string listText(const std::vector<std::string>& values)
{
    constexpr std::size_t widest = 110; // [characters]
    std::string text, line = "values = [";
    for (const std::string& value : values) {
        if (line.size() + value.size() > widest) {
            text += line + "\n";
            line = "         ";
        }
        line += (&value == &values.front() ? "" : " ") + tomlString(value) + (&value == &values.back() ? "" : ",");
    }
    return text + line + "]";
}

/// Settings that would make runs which cannot be compared.
std::optional<InputProblem> problemOfKey(const std::string& key)
{
    for (const char* fixed : {"model", "run.duration", "run.sample_interval"})
        if (key == fixed) return InputProblem{"", 0, key, "must be the same for all methods; set it for the case"};
    return {};
}

/// Applies and says where a setting would have no effect.
std::optional<InputProblem> apply(Case& c, const std::vector<CaseSetting>& settings, OutsidePaths outside)
{
    for (const CaseSetting& setting : settings)
        if (auto problem = problemOfKey(setting.key)) return problem;
    if (auto problem = changeCase(c, settings, outside)) return problem;
    for (const CaseSetting& setting : settings)
        if (const std::string message = unusedMessage(c, std::get<Parameter>(caseKey(c, setting.key)));
            !message.empty())
            return InputProblem{"", 0, setting.key, message};
    return {};
}

} // namespace

std::vector<MethodSpec> readMethods(StudyReader& reader, bool ensembles)
{
    std::vector<MethodSpec> specs;
    std::set<std::string> names;
    for (const std::string& table : reader.tables("method")) {
        MethodSpec& spec = specs.emplace_back();
        spec.outside = reader.outsidePaths();
        spec.name = reader.text(table + ".name").value_or("");
        spec.set = reader.settings(table + ".set");
        spec.key = reader.text(table + ".key").value_or("");
        if (const auto values = reader.texts(table + ".values")) spec.values = *values;
        if (const auto some = ensembles ? reader.texts(table + ".ensemble") : std::nullopt) spec.ensemble = *some;
        if (spec.name.empty())
            reader.add(table, "has no name");
        else if (!names.insert(spec.name).second)
            reader.add(table + ".name", inQuotes(spec.name) + " is the name of another method, too");
        if (spec.key.empty() && !spec.values.empty())
            reader.add(table + ".values", "are of no key; name it with key = \"run.step\"");
        if (!spec.key.empty() && spec.values.empty()) reader.add(table, "has no values of its key");
        for (const std::string& each : spec.ensemble)
            if (std::ranges::find(spec.values, each) == spec.values.end())
                reader.add(table + ".ensemble", inQuotes(each) + " is none of the values");
    }
    return specs;
}

std::vector<StudyKey> methodKeys(bool ensembles)
{
    std::vector<StudyKey> keys{
        inList(textKey("method.name", {}, "", "name in charts and tables")),
        inList(settingsKey("method.set", "changes of the case")),
        inList(textKey("method.key", {}, "", "key of the case that takes the values; none: one run")),
        inList(listKey("method.values", {}, "values of the key, in any order")),
    };
    if (ensembles)
        keys.push_back(inList(listKey("method.ensemble", {}, "values with which ensembles are made; default: all")));
    return keys;
}

std::string methodText(const MethodSpec& spec)
{
    std::string text = "\n[[method]]\nname = " + tomlString(spec.name) + "\nset = { ";
    for (const CaseSetting& setting : spec.set)
        text +=
            (&setting == &spec.set.front() ? "" : ", ") + tomlString(setting.key) + " = " + tomlString(setting.value);
    return text + " }\nkey = " + tomlString(spec.key) + "\n" + listText(spec.values) + "\n";
}

std::string nameOf(const std::string& method, const std::string& setting)
{
    return setting.empty() ? method : method + " (" + setting + ")";
}

std::optional<InputProblem> makeMethod(const Case& start, const MethodSpec& spec, SweptMethod& method, bool addOwn)
{
    method = {.name = spec.name, .key = spec.key};
    Case base = start;
    if (auto problem = apply(base, spec.set, spec.outside)) return problem;
    const bool own = std::ranges::all_of(spec.set, [&](const CaseSetting& setting) {
        const auto parameter = caseKey(start, setting.key);
        return std::holds_alternative<Parameter>(parameter) &&
               toText(base, std::get<Parameter>(parameter)) == toText(start, std::get<Parameter>(parameter));
    });
    if (spec.key.empty()) {
        method.settings.push_back({.label = "", .c = base, .chosen = own, .inEnsemble = true});
        return {};
    }
    const auto swept = caseKey(base, spec.key);
    const auto* parameter = std::get_if<Parameter>(&swept);
    if (parameter == nullptr)
        return apply(base, {{spec.key, ""}}, spec.outside); // which says what is wrong with the key
    bool found = false;
    for (const std::string& value : spec.values) {
        MethodSetting setting{.label = value, .c = base};
        if (auto problem = apply(setting.c, {{spec.key, fullValue(*parameter, value)}}, spec.outside)) return problem;
        setting.value = numberOf(*parameter, setting.c);
        setting.chosen = own && toText(setting.c, *parameter) == toText(start, *parameter);
        setting.inEnsemble = spec.ensemble.empty() || std::ranges::find(spec.ensemble, value) != spec.ensemble.end();
        found = found || setting.chosen;
        if (parameter->kind == ParameterKind::List) setting.label = labelOf(*parameter, setting.c);
        method.settings.push_back(std::move(setting));
    }
    if (addOwn && own && !found)
        method.settings.push_back({.label = labelOf(*parameter, base),
                                   .c = base,
                                   .value = numberOf(*parameter, base),
                                   .chosen = true,
                                   .inEnsemble = true});
    const int fineness = finenessOf(spec.key);
    method.ordered = fineness != 0;
    if (method.ordered)
        std::ranges::stable_sort(method.settings, {},
                                 [&](const MethodSetting& setting) { return fineness * setting.value; });
    return {};
}

} // namespace touchdown
