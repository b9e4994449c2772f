// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_kept_values.h"

#include <cmath>
#include <map>
#include <string_view>

#include "core/case/parameters.h"
#include "core/formats/quotation.h"
#include "core/formats/toml_document.h"

namespace touchdown {

namespace {

constexpr std::string_view mark = "touchdown: ";

/// Both texts of one key.
struct KeptValue {
    std::string was;
    std::string is;
};

/// More than by the last digits, which units may change.
bool differ(const ParameterValue& a, const ParameterValue& b)
{
    const auto* x = std::get_if<double>(&a);
    const auto* y = std::get_if<double>(&b);
    return x == nullptr || y == nullptr || std::abs(*x - *y) > 1e-12 * std::abs(*x);
}

std::map<std::string, KeptValue> readKeptValues(const std::string& toml, CmlParameters& parameters)
{
    std::map<std::string, KeptValue> values;
    const TomlDocument document = readToml(toml);
    if (!document.problem.empty())
        parameters.addWarning(0, "the values that the comments keep cannot be read: " + document.problem);
    for (const TomlEntry& entry : document.entries) {
        const auto dot = entry.key.find_last_of('.');
        const auto* text = std::get_if<std::string>(&entry.value);
        if (dot == std::string::npos || text == nullptr) continue;
        KeptValue& value = values[entry.key.substr(0, dot)];
        if (entry.key.substr(dot + 1) == "was") value.was = *text;
        if (entry.key.substr(dot + 1) == "is") value.is = *text;
    }
    return values;
}

} // namespace

CmlKeptValues keepValues(const Case& wanted, const Case& read)
{
    CmlKeptValues kept;
    for (const Parameter& parameter : parameters()) {
        if (parameter.get(wanted) == parameter.get(read)) continue;
        kept.comments.append(mark)
            .append(parameter.key)
            .append(" = { was = " + tomlString(toText(read, parameter)))
            .append(", is = " + tomlString(toText(wanted, parameter)) + " }\r\n");
        if (differ(parameter.get(wanted), parameter.get(read)) && parameter.used(wanted) && parameter.key != "title" &&
            parameter.group() != "about")
            kept.keys.push_back(parameter.key);
    }
    return kept;
}

void applyKeptValues(CmlParameters& parameters)
{
    std::string toml;
    std::string rest;
    CmlText lines(parameters.comments);
    while (!lines.atEnd()) {
        const std::string_view line = lines.takeLine();
        if (line.starts_with(mark))
            toml.append(line.substr(mark.size())).append("\n");
        else
            rest.append(line).append("\n");
    }
    parameters.comments = rest;
    if (toml.empty()) return;

    const Case read = parameters.value();
    for (const auto& [key, kept] : readKeptValues(toml, parameters)) {
        const Parameter* const parameter = findParameter(key);
        if (parameter == nullptr)
            parameters.addWarning(0, "the comments keep a value for " + inQuotes(key) + ", an unknown key");
        else if (toText(read, *parameter) != kept.was)
            parameters.addWarning(0, "the comments keep " + inQuotes(kept.is) + " for " + key + " in place of " +
                                         inQuotes(kept.was) + ", but the files now say " +
                                         inQuotes(toText(read, *parameter)) + ", which holds");
        else
            parameters.choose(key, kept.is, parameters.lineOf(key));
    }
}

} // namespace touchdown
