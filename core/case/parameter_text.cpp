// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of parameters as text: reading, range checks, writing.
#include "core/case/parameters.h"

#include "core/formats/decimal.h"
#include "core/formats/quotation.h"
#include "core/formats/units.h"
#include "core/formats/words.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace touchdown {

namespace {

constexpr std::size_t longestText = 4000; // [byte]

/// A limit or a value in a message: in the display unit, or in SI where that takes fewer digits ("10 kg", not "1e7
/// mg").
std::string shown(double value, const Parameter& parameter)
{
    if (parameter.unit.empty()) return formatNumber(value);
    if (!std::isfinite(value)) return formatNumber(value) + ' ' + parameter.displayUnit;
    const std::string people = formatQuantity(value, parameter.displayUnit);
    const std::string si = formatQuantity(value, parameter.unit);
    return value != 0.0 && si.size() < people.size() ? si : people;
}

/// What each number must satisfy.
std::string numberRange(const Parameter& parameter)
{
    if (parameter.stride > 0)
        return shown(parameter.minimum, parameter) + ", " + shown(parameter.minimum + parameter.stride, parameter) +
               ", " + shown(parameter.minimum + 2 * parameter.stride, parameter) + " and so on to " +
               shown(parameter.maximum, parameter);
    if (parameter.minimum == parameter.maximum) return shown(parameter.minimum, parameter);
    std::string range;
    if (std::isfinite(parameter.minimum))
        range = (parameter.minimumAllowed ? "at least " : "greater than ") + shown(parameter.minimum, parameter);
    if (std::isfinite(parameter.maximum))
        range += (range.empty() ? "at most " : ", at most ") + shown(parameter.maximum, parameter);
    return range.empty() ? "any finite number" : range;
}

std::optional<std::string> checkNumber(const Parameter& parameter, double value)
{
    if (!std::isfinite(value)) return "is not a finite number";
    const bool enough = parameter.minimumAllowed ? value >= parameter.minimum : value > parameter.minimum;
    if (!enough || value > parameter.maximum)
        return shown(value, parameter) + " is out of range: allowed is " + allowedRange(parameter);
    if (parameter.stride > 0 && std::fmod(value - parameter.minimum, parameter.stride) != 0.0)
        return shown(value, parameter) + " is not possible: allowed is " + allowedRange(parameter);
    return {};
}

std::optional<std::string> setNumber(Case& target, const Parameter& parameter, double value)
{
    if (auto problem = checkNumber(parameter, value)) return problem;
    parameter.set(target, value);
    return {};
}

std::string countRange(const Parameter& parameter)
{
    const std::string most = std::to_string(parameter.maximumCount);
    return parameter.minimumCount == parameter.maximumCount ? most : "at most " + most;
}

/// A number as a person writes it; a bare one is SI, so that it is read as a dimensionless one.
std::variant<double, UnitProblem> readNumber(const Parameter& parameter, std::string_view text)
{
    const bool bare = !text.empty() && text.find_first_not_of("0123456789+-.eE") == std::string_view::npos;
    return parseQuantity(text, bare || parameter.kind == ParameterKind::Integer ? std::string_view() : parameter.unit);
}

std::optional<std::string> setList(Case& target, const Parameter& parameter, std::string_view text)
{
    std::vector<double> values;
    for (const std::string_view element : listElements(text)) {
        if (values.size() > parameter.maximumCount) break;
        const auto number = readNumber(parameter, withoutQuotes(element));
        if (const auto* problem = std::get_if<UnitProblem>(&number)) {
            const bool several = element.find_first_of(' ') != std::string_view::npos && parameter.unit.empty();
            return several ? inQuotes(element) + " is not a number; separate the numbers of a list by commas"
                           : problem->message;
        }
        values.push_back(std::get<double>(number));
    }
    return setFromNumbers(target, parameter, values);
}

std::optional<std::string> setInteger(Case& target, const Parameter& parameter, double value)
{
    if (std::trunc(value) != value) return formatNumber(value) + " is not a whole number";
    if (value < parameter.minimum || value > parameter.maximum)
        return formatNumber(value) + " is out of range: allowed is " + allowedRange(parameter);
    parameter.set(target, static_cast<int>(value));
    return {};
}

std::optional<std::string> setText(Case& target, const Parameter& parameter, std::string_view text)
{
    if (findInvalidUtf8(text) != std::string_view::npos) return inQuotes(text) + " is not valid UTF-8 text";
    if (text.size() > longestText) return "is longer than " + std::to_string(longestText) + " bytes";
    for (const char c : text)
        if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f)
            return inQuotes(text) + " holds control characters";
    parameter.set(target, std::string(text));
    return {};
}

} // namespace

double numberOf(const Parameter& parameter, const Case& c)
{
    const ParameterValue value = parameter.get(c);
    if (const auto* number = std::get_if<double>(&value)) return *number;
    if (const auto* whole = std::get_if<int>(&value)) return *whole;
    if (const auto* list = std::get_if<std::vector<double>>(&value); list != nullptr && !list->empty())
        return list->front();
    return std::nan("");
}

std::string allowedRange(const Parameter& parameter)
{
    switch (parameter.kind) {
    case ParameterKind::Choice:
        return parameter.choices.size() == 1 ? parameter.choices.front() : "one of " + joined(parameter.choices);
    case ParameterKind::Boolean: return "true or false";
    case ParameterKind::Text: return "text of at most " + std::to_string(longestText) + " bytes";
    case ParameterKind::List: return countRange(parameter) + " numbers, each " + numberRange(parameter);
    case ParameterKind::Number:
    case ParameterKind::Integer: break;
    }
    return numberRange(parameter);
}

std::optional<std::string> setFromText(Case& target, const Parameter& parameter, std::string_view text)
{
    if (parameter.kind == ParameterKind::Text) return setText(target, parameter, text);
    const std::string_view value = trimmed(text);
    if (parameter.kind == ParameterKind::Choice) {
        for (const auto* names : {&parameter.choices, &parameter.spellings})
            if (std::ranges::find(*names, value) != names->end()) {
                parameter.set(target, std::string(value));
                return {};
            }
        return inQuotes(value) + " is not known: allowed is " + allowedRange(parameter);
    }
    if (parameter.kind == ParameterKind::Boolean) {
        if (value != "true" && value != "false") return inQuotes(value) + " is neither true nor false";
        parameter.set(target, value == "true");
        return {};
    }
    if (parameter.kind == ParameterKind::List) return setList(target, parameter, value);
    const auto number = readNumber(parameter, value);
    if (const auto* problem = std::get_if<UnitProblem>(&number)) return problem->message;
    return setFromNumber(target, parameter, std::get<double>(number));
}

std::optional<std::string> setFromNumber(Case& target, const Parameter& parameter, double value)
{
    switch (parameter.kind) {
    case ParameterKind::Number: return setNumber(target, parameter, value);
    case ParameterKind::Integer: return setInteger(target, parameter, value);
    case ParameterKind::Choice: break;
    case ParameterKind::Boolean: break;
    case ParameterKind::Text: return "is a number; text is needed";
    case ParameterKind::List: return setFromNumbers(target, parameter, {value});
    }
    return "is a number; allowed is " + allowedRange(parameter);
}

std::optional<std::string> setFromNumbers(Case& target, const Parameter& parameter, const std::vector<double>& values)
{
    if (parameter.kind != ParameterKind::List) return "is a list; allowed is " + allowedRange(parameter);
    if (values.size() > parameter.maximumCount) return "has too many numbers: allowed is " + allowedRange(parameter);
    if (values.size() < parameter.minimumCount)
        return "has " + std::to_string(values.size()) + (values.size() == 1 ? " number" : " numbers") +
               ": allowed is " + allowedRange(parameter);
    for (const double value : values)
        if (auto problem = checkNumber(parameter, value)) return problem;
    parameter.set(target, values);
    return {};
}

std::vector<std::string_view> listElements(std::string_view text)
{
    text = trimmed(text);
    if (text.starts_with('[') && text.ends_with(']') && text.size() > 1)
        text = trimmed(text.substr(1, text.size() - 2));
    std::vector<std::string_view> elements;
    while (!text.empty()) {
        const auto comma = std::min(text.find_first_of(",;"), text.size());
        elements.push_back(trimmed(text.substr(0, comma)));
        // A comma at the end is none too many, as in TOML.
        text = trimmed(text.substr(std::min(comma + 1, text.size())));
    }
    return elements;
}

std::string toText(const Case& from, const Parameter& parameter)
{
    const ParameterValue value = parameter.get(from);
    if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
        std::string text;
        for (const double number : *numbers)
            text += (text.empty() ? "" : ", ") + formatQuantity(number, parameter.displayUnit);
        return text;
    }
    if (const auto* number = std::get_if<double>(&value)) return formatQuantity(*number, parameter.displayUnit);
    if (const auto* integer = std::get_if<int>(&value)) return std::to_string(*integer);
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    return std::get<std::string>(value);
}

} // namespace touchdown
