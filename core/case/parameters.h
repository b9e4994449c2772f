// SPDX-License-Identifier: GPL-3.0-or-later
//
// The description of every parameter of a Case, in one place: key, unit, range, default, help text, source. The reader
// and writer of case files, validation, `--set`, `describe`, the results file and the parameter panel use it.
#pragma once

#include "core/case/case.h"
#include "core/formats/input_problem.h"

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace touchdown {

enum class ParameterKind : std::uint8_t { Number, Integer, Choice, Boolean, Text, List };

/// A parameter's value, by kind: Number -> double [SI], Integer -> int, Choice and Text -> string, Boolean -> bool,
/// List -> doubles [SI].
using ParameterValue = std::variant<double, int, bool, std::string, std::vector<double>>;

struct Parameter {
    std::string key{};    // "springs.front_stiffness"
    std::string label{};  // "front stiffness"
    std::string symbol{}; // "k_f0"; empty if it has none
    ParameterKind kind = ParameterKind::Number;
    std::string unit{};        // SI unit of a Number or a List, in UDUNITS spelling; empty when dimensionless
    std::string displayUnit{}; // the unit people use, "nm"
    double minimum = -std::numeric_limits<double>::infinity(); // [unit]
    double maximum = std::numeric_limits<double>::infinity();  // [unit]
    bool minimumAllowed = true;                                // false: a value must be greater than `minimum`
    int stride = 0;               // List: distance of the allowed whole numbers, from `minimum` on; 0: any number
    std::size_t minimumCount = 0; // List: how many numbers
    std::size_t maximumCount = 0;
    std::vector<std::string> choices{};   // Choice: the names
    std::vector<std::string> spellings{}; // Choice: further names that are read, but never written
    std::string help{};                   // the effect, in a sentence
    std::string source{}; // of the parameter or its default; contains "assumed" if the paper's value is lost
    std::function<ParameterValue(const Case&)> get{};
    std::function<void(Case&, const ParameterValue&)> set{}; // the value's alternative must fit the kind
    std::function<bool(const Case&)> used{};                 // false: the chosen models do not have this parameter

    /// "springs" of "springs.cutoff", "disk.surface" of "disk.surface.rms"; empty for the root keys.
    std::string group() const;
    /// "cutoff" of "springs.cutoff".
    std::string_view leaf() const;
};

/// The default values of a model: those of core/case/case.h, but a film case has no contact, is free to roll and runs
/// for 0.5 ms, and a contact case is elastic and takes 400 samples.
Case defaultsOf(ModelKind model);

/// Whether the case uses the air bearing surface.
bool usesSliderSurface(const Case& c);

/// States that a parameter has no effect on a case, and which choice would give it one: "has no effect here, only with
/// run.steps = "fixed""; empty if the parameter is used.
std::string unusedMessage(const Case& c, const Parameter& parameter);

/// All parameters, in the order of a case file.
std::span<const Parameter> parameters();
/// The parameter of a key, or nullptr.
const Parameter* findParameter(std::string_view key);
/// The key nearest to a misspelt one; empty if none is near.
std::string nearestKey(std::string_view key);

/// The condition on a value: "greater than 0 kg, at most 1e-3 kg", "one of none, ono-yamane".
std::string allowedRange(const Parameter& parameter);

/// Reads a value as a case file or a person writes it ("7 nm", "0.3", "dopri5", "true", "20 mm, 30 mm"); bare numbers
/// are SI. On failure the case is unchanged, and the reason is returned as one sentence without the key.
std::optional<std::string> setFromText(Case& target, const Parameter& parameter, std::string_view text);
/// The same for numbers in SI.
std::optional<std::string> setFromNumber(Case& target, const Parameter& parameter, double value);
std::optional<std::string> setFromNumbers(Case& target, const Parameter& parameter, const std::vector<double>& values);

/// The value of a number, the first one of a list [unit of the parameter]; NaN of others.
double numberOf(const Parameter& parameter, const Case& c);

/// The numbers of a List as people write them, separated by commas or semicolons.
std::vector<std::string_view> listElements(std::string_view text);

/// The value as a case file writes it, without quotation marks: in the display unit, with the fewest digits that read
/// back as the same number.
std::string toText(const Case& from, const Parameter& parameter);

/// Values that contradict each other.
struct CaseProblem {
    std::string key;
    std::string message;                  // a sentence without the key
    std::vector<std::string> otherKeys{}; // the values, or the groups of values, with which the key is combined

    /// Whether the value or the group of this key takes part.
    bool concerns(std::string_view anyKey) const;
    /// The same problem with its place in an input.
    InputProblem in(const std::string& file, int line = 0) const;
};
std::vector<CaseProblem> checkCombinations(const Case& c);

/// What a case may have, but what its user may not know of: a contact that creates energy, ridges narrower than a cell.
std::vector<CaseProblem> caseWarnings(const Case& c);

} // namespace touchdown
