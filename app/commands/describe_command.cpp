// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/describe_command.h"

#include <algorithm>
#include <vector>

#include "app/commands/describe_study.h"
#include "app/terminal/console.h"
#include "app/terminal/json_text.h"
#include "app/terminal/wrapped_text.h"
#include "core/case/fields.h"
#include "core/case_files/surface_text.h"
#include "core/formats/nearest_name.h"
#include "core/studies/study_plan.h"

namespace touchdown {
namespace {

using Selection = std::vector<const Field*>;

std::string kindName(const Field& field)
{
    switch (field.kind) {
    case FieldKind::Number: return "number";
    case FieldKind::Integer: return "integer";
    case FieldKind::Choice: return "choice";
    case FieldKind::Boolean: return "boolean";
    case FieldKind::Text: return "text";
    case FieldKind::List: return "list";
    }
    return {};
}

Selection select(const std::string& key)
{
    Selection selection;
    for (const Field& field : fields())
        if (key.empty() || field.key == key || field.group() == key) selection.push_back(&field);
    return selection;
}

// The key, group or kind of study that was meant.
std::string nearest(const std::string& key)
{
    if (const std::string name = nearestKey(key); !name.empty()) return name;
    std::vector<std::string> groups;
    for (const Field& field : fields())
        if (!field.group().empty() && (groups.empty() || groups.back() != field.group()))
            groups.push_back(field.group());
    for (const StudyKind& kind : studyKinds()) groups.push_back(kind.name);
    return nearestName(key, groups);
}

std::string defaultText(const Field& field)
{
    const auto shown = [&](ModelKind model) {
        const std::string text = toText(defaultsOf(model), field);
        return text.empty() ? "(empty)" : text;
    };
    std::string text = shown(ModelKind::Springs);
    // The choice of the model itself is no default of a model.
    if (field.key == "model") return text;
    const auto add = [&, springs = text](const char* name, ModelKind model) {
        if (const std::string other = shown(model); other != springs) text += std::string("; ") + name + ": " + other;
    };
    add("film", ModelKind::Film);
    add("contact", ModelKind::Contact);
    return text;
}

std::string unitText(const Field& field)
{
    const bool numbers = field.kind == FieldKind::Number || field.kind == FieldKind::List;
    if (field.unit.empty()) return numbers ? "-" : "";
    return field.unit == field.displayUnit ? field.unit : field.displayUnit + " (" + field.unit + ")";
}

std::string table(const Selection& selection)
{
    std::size_t keyWidth = 3;
    std::size_t unitWidth = 4;
    std::size_t defaultWidth = 7;
    for (const Field* field : selection) {
        keyWidth = std::max(keyWidth, field->key.size());
        unitWidth = std::max(unitWidth, unitText(*field).size());
        defaultWidth = std::max(defaultWidth, defaultText(*field).size());
    }
    std::string text =
        padded("KEY", keyWidth) + padded("UNIT", unitWidth) + padded("DEFAULT", defaultWidth) + "ALLOWED\n";
    std::string group;
    for (std::size_t i = 0; i < selection.size(); ++i) {
        const Field* field = selection[i];
        if (field->group() != group) text += "\n[" + field->group() + "]\n";
        group = field->group();
        text += padded(field->key, keyWidth) + padded(unitText(*field), unitWidth) +
                padded(defaultText(*field), defaultWidth) + allowedRange(*field) + "\n";
        text += wrapped(field->help + (field->source.empty() ? "" : " Source: " + field->source + "."), 6);
        const bool last = i + 1 == selection.size() || selection[i + 1]->group() != group;
        if (group == "abs" && last && selection.size() > 1) text += wrapped(std::string(surfaceHelp()), 6);
    }
    return text;
}

std::string details(const Field& field)
{
    const auto line = [](const char* name, const std::string& value) {
        return value.empty() ? std::string() : padded(name, 8) + value + "\n";
    };
    return line("key", field.key) + line("name", field.label) + line("symbol", field.symbol) +
           line("kind", kindName(field)) + line("unit", unitText(field)) + line("default", defaultText(field)) +
           line("allowed", allowedRange(field)) + line("effect", field.help) + line("source", field.source);
}

Json json(const Field& field)
{
    const auto value = [](const FieldValue& v) { return std::visit([](const auto& x) { return Json(x); }, v); };
    Json result{{"key", field.key}, {"label", field.label}, {"symbol", field.symbol}, {"kind", kindName(field)}};
    const bool list = field.kind == FieldKind::List;
    if (field.kind == FieldKind::Number || list) {
        result["unit"] = field.unit.empty() ? "1" : field.unit;
        result["display_unit"] = field.displayUnit;
    }
    if (list) result["minimum_count"] = field.minimumCount;
    if (list) result["maximum_count"] = field.maximumCount;
    if (field.kind == FieldKind::Number || field.kind == FieldKind::Integer || list) {
        result["minimum"] = jsonNumber(field.minimum);
        result["minimum_allowed"] = field.minimumAllowed;
        result["maximum"] = jsonNumber(field.maximum);
    }
    if (field.kind == FieldKind::Choice) result["choices"] = field.choices;
    result["default"] = value(field.get(Case{}));
    result["allowed"] = allowedRange(field);
    result["help"] = field.help;
    result["source"] = field.source;
    return result;
}

} // namespace

int describeCommand(const std::string& key, bool asJson)
{
    const Selection selection = select(key);
    if (isSurfaceKey(key) || key == railFileKey) {
        print(asJson ? jsonText({{"fields", Json::array()}, {"surface", surfaceHelp()}})
                     : wrapped(std::string(surfaceHelp()), 0));
        return exitDone;
    }
    if (selection.empty()) {
        if (const auto code = describeStudy(key, asJson)) return *code;
        complain(key + ": unknown key" + didYouMean(nearest(key)));
        return exitWrongInput;
    }
    if (asJson) {
        Json all = Json::array();
        for (const Field* field : selection) all.push_back(json(*field));
        Json result{{"fields", all}};
        if (key.empty() || key == "abs") result["surface"] = surfaceHelp();
        print(jsonText(result));
    } else {
        print(selection.size() == 1 && selection.front()->key == key ? details(*selection.front()) : table(selection));
    }
    return exitDone;
}

} // namespace touchdown
