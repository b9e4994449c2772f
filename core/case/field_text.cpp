// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of fields as text: reading, range checks, writing.
#include "core/case/fields.h"

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
std::string shown(double value, const Field& field)
{
    if (field.unit.empty()) return formatNumber(value);
    if (!std::isfinite(value)) return formatNumber(value) + ' ' + field.displayUnit;
    const std::string people = formatQuantity(value, field.displayUnit);
    const std::string si = formatQuantity(value, field.unit);
    return value != 0.0 && si.size() < people.size() ? si : people;
}

/// What each number must satisfy.
std::string numberRange(const Field& field)
{
    if (field.stride > 0)
        return shown(field.minimum, field) + ", " + shown(field.minimum + field.stride, field) + ", " +
               shown(field.minimum + 2 * field.stride, field) + " and so on to " + shown(field.maximum, field);
    if (field.minimum == field.maximum) return shown(field.minimum, field);
    std::string range;
    if (std::isfinite(field.minimum))
        range = (field.minimumAllowed ? "at least " : "greater than ") + shown(field.minimum, field);
    if (std::isfinite(field.maximum))
        range += (range.empty() ? "at most " : ", at most ") + shown(field.maximum, field);
    return range.empty() ? "any finite number" : range;
}

std::optional<std::string> checkNumber(const Field& field, double value)
{
    if (!std::isfinite(value)) return "is not a finite number";
    const bool enough = field.minimumAllowed ? value >= field.minimum : value > field.minimum;
    if (!enough || value > field.maximum)
        return shown(value, field) + " is out of range: allowed is " + allowedRange(field);
    if (field.stride > 0 && std::fmod(value - field.minimum, field.stride) != 0.0)
        return shown(value, field) + " is not possible: allowed is " + allowedRange(field);
    return {};
}

std::optional<std::string> setNumber(Case& target, const Field& field, double value)
{
    if (auto problem = checkNumber(field, value)) return problem;
    field.set(target, value);
    return {};
}

std::string countRange(const Field& field)
{
    const std::string most = std::to_string(field.maximumCount);
    return field.minimumCount == field.maximumCount ? most : "at most " + most;
}

/// A number as a person writes it; a bare one is SI, so that it is read as a dimensionless one.
std::variant<double, UnitProblem> readNumber(const Field& field, std::string_view text)
{
    const bool bare = !text.empty() && text.find_first_not_of("0123456789+-.eE") == std::string_view::npos;
    return parseQuantity(text, bare || field.kind == FieldKind::Integer ? std::string_view() : field.unit);
}

std::optional<std::string> setList(Case& target, const Field& field, std::string_view text)
{
    std::vector<double> values;
    for (const std::string_view element : listElements(text)) {
        if (values.size() > field.maximumCount) break;
        const auto number = readNumber(field, withoutQuotes(element));
        if (const auto* problem = std::get_if<UnitProblem>(&number)) {
            const bool several = element.find_first_of(' ') != std::string_view::npos && field.unit.empty();
            return several ? inQuotes(element) + " is not a number; separate the numbers of a list by commas"
                           : problem->message;
        }
        values.push_back(std::get<double>(number));
    }
    return setFromNumbers(target, field, values);
}

std::optional<std::string> setInteger(Case& target, const Field& field, double value)
{
    if (std::trunc(value) != value) return formatNumber(value) + " is not a whole number";
    if (value < field.minimum || value > field.maximum)
        return formatNumber(value) + " is out of range: allowed is " + allowedRange(field);
    field.set(target, static_cast<int>(value));
    return {};
}

std::optional<std::string> setText(Case& target, const Field& field, std::string_view text)
{
    if (findInvalidUtf8(text) != std::string_view::npos) return inQuotes(text) + " is not valid UTF-8 text";
    if (text.size() > longestText) return "is longer than " + std::to_string(longestText) + " bytes";
    for (const char c : text)
        if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f)
            return inQuotes(text) + " holds control characters";
    field.set(target, std::string(text));
    return {};
}

} // namespace

std::string allowedRange(const Field& field)
{
    switch (field.kind) {
    case FieldKind::Choice:
        return field.choices.size() == 1 ? field.choices.front() : "one of " + joined(field.choices);
    case FieldKind::Boolean: return "true or false";
    case FieldKind::Text: return "text of at most " + std::to_string(longestText) + " bytes";
    case FieldKind::List: return countRange(field) + " numbers, each " + numberRange(field);
    case FieldKind::Number:
    case FieldKind::Integer: break;
    }
    return numberRange(field);
}

std::optional<std::string> setFromText(Case& target, const Field& field, std::string_view text)
{
    if (field.kind == FieldKind::Text) return setText(target, field, text);
    const std::string_view value = trimmed(text);
    if (field.kind == FieldKind::Choice) {
        for (const std::string& name : field.choices) {
            if (name != value) continue;
            field.set(target, name);
            return {};
        }
        return inQuotes(value) + " is not known: allowed is " + allowedRange(field);
    }
    if (field.kind == FieldKind::Boolean) {
        if (value != "true" && value != "false") return inQuotes(value) + " is neither true nor false";
        field.set(target, value == "true");
        return {};
    }
    if (field.kind == FieldKind::List) return setList(target, field, value);
    const auto number = readNumber(field, value);
    if (const auto* problem = std::get_if<UnitProblem>(&number)) return problem->message;
    return setFromNumber(target, field, std::get<double>(number));
}

std::optional<std::string> setFromNumber(Case& target, const Field& field, double value)
{
    switch (field.kind) {
    case FieldKind::Number: return setNumber(target, field, value);
    case FieldKind::Integer: return setInteger(target, field, value);
    case FieldKind::Choice: break;
    case FieldKind::Boolean: break;
    case FieldKind::Text: return "is a number; text is needed";
    case FieldKind::List: return setFromNumbers(target, field, {value});
    }
    return "is a number; allowed is " + allowedRange(field);
}

std::optional<std::string> setFromNumbers(Case& target, const Field& field, const std::vector<double>& values)
{
    if (field.kind != FieldKind::List) return "is a list; allowed is " + allowedRange(field);
    if (values.size() > field.maximumCount) return "has too many numbers: allowed is " + allowedRange(field);
    if (values.size() < field.minimumCount)
        return "has " + std::to_string(values.size()) + (values.size() == 1 ? " number" : " numbers") +
               ": allowed is " + allowedRange(field);
    for (const double value : values)
        if (auto problem = checkNumber(field, value)) return problem;
    field.set(target, values);
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

std::string toText(const Case& from, const Field& field)
{
    const FieldValue value = field.get(from);
    if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
        std::string text;
        for (const double number : *numbers)
            text += (text.empty() ? "" : ", ") + formatQuantity(number, field.displayUnit);
        return text;
    }
    if (const auto* number = std::get_if<double>(&value)) return formatQuantity(*number, field.displayUnit);
    if (const auto* integer = std::get_if<int>(&value)) return std::to_string(*integer);
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    return std::get<std::string>(value);
}

} // namespace touchdown
