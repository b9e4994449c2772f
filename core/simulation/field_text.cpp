// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of fields as text: reading, range checks, writing.
#include "core/simulation/fields.h"

#include "core/simulation/decimal.h"
#include "core/simulation/quotation.h"
#include "core/simulation/units.h"

#include <charconv>
#include <cmath>

namespace touchdown {

namespace {

constexpr std::size_t longestText = 4000; // [byte]

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view space = " \t\r\n";
    const auto first = text.find_first_not_of(space);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(space) - first + 1);
}

/// A limit or a value in a message: in the display unit, or in SI where that takes fewer digits ("10 kg", not "1e7 mg").
std::string shown(double value, const Field& field)
{
    if (field.unit.empty()) return formatNumber(value);
    if (!std::isfinite(value)) return formatNumber(value) + ' ' + field.displayUnit;
    const std::string people = formatQuantity(value, field.displayUnit);
    const std::string si = formatQuantity(value, field.unit);
    return value != 0.0 && si.size() < people.size() ? si : people;
}

std::string joined(const std::vector<std::string>& names)
{
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

std::optional<std::string> setNumber(Case& target, const Field& field, double value)
{
    if (!std::isfinite(value)) return "is not a finite number";
    const bool enough = field.minimumAllowed ? value >= field.minimum : value > field.minimum;
    if (!enough || value > field.maximum)
        return shown(value, field) + " is out of range: allowed is " + allowedRange(field);
    field.set(target, value);
    return {};
}

std::optional<std::string> setInteger(Case& target, const Field& field, double value)
{
    if (std::trunc(value) != value) return formatNumber(value) + " is no whole number";
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
    case FieldKind::Number:
    case FieldKind::Integer: break;
    }
    if (field.minimum == field.maximum) return shown(field.minimum, field);
    std::string range;
    if (std::isfinite(field.minimum))
        range = (field.minimumAllowed ? "at least " : "greater than ") + shown(field.minimum, field);
    if (std::isfinite(field.maximum))
        range += (range.empty() ? "at most " : ", at most ") + shown(field.maximum, field);
    return range.empty() ? "any finite number" : range;
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
    // A bare number is SI, so it is read as a dimensionless one.
    const bool bare = !value.empty() && value.find_first_not_of("0123456789+-.eE") == std::string_view::npos;
    const auto number =
        parseQuantity(value, bare || field.kind == FieldKind::Integer ? std::string_view() : field.unit);
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
    }
    return "is a number; allowed is " + allowedRange(field);
}

std::string toText(const Case& from, const Field& field)
{
    const FieldValue value = field.get(from);
    if (const auto* number = std::get_if<double>(&value)) return formatQuantity(*number, field.displayUnit);
    if (const auto* integer = std::get_if<int>(&value)) return std::to_string(*integer);
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    return std::get<std::string>(value);
}

} // namespace touchdown
