// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conversion of units, in one place, by UDUNITS-2. Thread-safe.
#pragma once

#include <string>
#include <string_view>
#include <variant>

namespace touchdown {

/// Why a text is not a quantity of the expected unit: one sentence.
struct UnitProblem {
    std::string message;
};

/// "7 nm" to 7e-9 for unit "m". `unit` is the expected SI unit; "" for a dimensionless number, which may have "%".
/// The decimal separator is a point in every locale. A number without a unit is a problem unless `unit` is "".
std::variant<double, UnitProblem> parseQuantity(std::string_view text, std::string_view unit);

/// The factor from a display unit to SI: 1e-9 for "nm". The unit must be known (assert).
double unitFactor(std::string_view unit);

/// The shortest text that reads back as the same number: "7 nm" for 7e-9 and "nm".
std::string formatQuantity(double value, std::string_view displayUnit);

/// The same without the unit.
std::string formatNumber(double value, std::string_view displayUnit = {});

/// Rounded to `digits` significant digits; 0 stays 0.
double roundedTo(double value, int digits);

/// The same in the display unit: formatQuantity writes it with no more than `digits` digits.
double roundedIn(double value, std::string_view displayUnit, int digits);

/// A number for a sentence, with as many digits as it is worth: "3.1e-6 nm"; "15" with an empty unit.
std::string fewDigits(double value, std::string_view displayUnit, int digits = 2);
std::string inNanometres(double length); // four digits
/// In s, ms, us or ns, so that the number is short.
std::string fewDigitsOfTime(double seconds, int digits = 2);
/// "31 %" of 0.31.
std::string percent(double share, int digits = 2);

} // namespace touchdown
