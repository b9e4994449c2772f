// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one description of every field of a Case: key, unit, range, default, help text, source. It feeds
// the file reader and writer, validation, `--set`, `describe`, the results file and the parameter panel.
#pragma once

#include "core/case/case.h"

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace touchdown {

enum class FieldKind : std::uint8_t { Number, Integer, Choice, Boolean, Text, List };

/// A field's value, by kind: Number -> double [SI], Integer -> int, Choice and Text -> string, Boolean -> bool,
/// List -> doubles [SI].
using FieldValue = std::variant<double, int, bool, std::string, std::vector<double>>;

struct Field {
    std::string key{};    // "springs.front_stiffness"
    std::string label{};  // "front stiffness"
    std::string symbol{}; // "k_f0"; empty if it has none
    FieldKind kind = FieldKind::Number;
    std::string unit{};        // SI unit of a Number or a List, in UDUNITS spelling; empty when dimensionless
    std::string displayUnit{}; // the unit people use, "nm"
    double minimum = -std::numeric_limits<double>::infinity(); // [unit]
    double maximum = std::numeric_limits<double>::infinity();  // [unit]
    bool minimumAllowed = true;                                // false: must be greater than `minimum`
    int stride = 0;               // of the whole numbers of a List, from `minimum` on; 0: any number in the range
    std::size_t minimumCount = 0; // of the numbers of a List
    std::size_t maximumCount = 0;
    std::vector<std::string> choices{}; // names, for a Choice
    std::string help{};                 // what it does, in a sentence
    std::string source{}; // where it, or its default, comes from; says "assumed" where the paper's value is lost
    std::function<FieldValue(const Case&)> get{};
    std::function<void(Case&, const FieldValue&)> set{}; // the value's alternative must fit the kind
    std::function<bool(const Case&)> used{};             // false: the chosen model has no such parameter

    /// "springs" of "springs.cutoff", "disk.surface" of "disk.surface.rms"; empty for the root keys.
    std::string group() const;
};

/// What a case has where nobody says otherwise: as in core/case/case.h, but a film case is without contact, free
/// to roll and runs for 0.5 ms, and a contact case is elastic and takes 400 samples.
Case defaultsOf(ModelKind model);

/// Whether the air bearing surface takes part.
bool usesSliderSurface(const Case& c);

/// Says that a field has no effect on a case, and which one choice would give it one: "has no effect here, only with
/// run.steps =
/// \"fixed\""; empty where it is used.
std::string unusedMessage(const Case& c, const Field& field);

/// All fields, in the order of a case file.
std::span<const Field> fields();
/// The field of a key; nullptr if there is none.
const Field* findField(std::string_view key);
/// The key that was most likely meant; empty if none is near.
std::string nearestKey(std::string_view key);

/// "greater than 0 kg, at most 1e-3 kg", "one of none, ono-yamane": what a value must satisfy.
std::string allowedRange(const Field& field);

/// Reads a value as a case file or a person writes it ("7 nm", "0.3", "dopri5", "true", "20 mm, 30 mm"); bare numbers
/// are SI.
/// On failure returns the reason as one sentence without the key, and leaves the case alone.
std::optional<std::string> setFromText(Case& target, const Field& field, std::string_view text);
/// Sets a bare SI number; the same checks.
std::optional<std::string> setFromNumber(Case& target, const Field& field, double value);

std::optional<std::string> setFromNumbers(Case& target, const Field& field, const std::vector<double>& values);

/// The numbers of a List as people write them, separated by commas or semicolons.
std::vector<std::string_view> listElements(std::string_view text);

/// The value as a case file writes it, without quotes: shortest text that reads back as the same number, in the display
/// unit.
std::string toText(const Case& from, const Field& field);

/// Combinations that make no sense. Each problem names its keys.
struct CaseProblem {
    std::string key;
    std::string message; // a sentence
};
std::vector<CaseProblem> checkCombinations(const Case& c);

} // namespace touchdown
