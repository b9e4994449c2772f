// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one place where units are converted; UDUNITS-2 knows the units. Safe to call from any thread.
#pragma once

#include <string>
#include <string_view>
#include <variant>

namespace touchdown {

/// Why a text is no quantity of the wanted unit: one sentence.
struct UnitProblem {
    std::string message;
};

/// "7 nm" to 7e-9 for unit "m". `unit` is the SI unit wanted; "" for a dimensionless number, which may carry "%".
/// Decimal point only, whatever the locale. A number without a unit is a problem unless `unit` is "".
std::variant<double, UnitProblem> parseQuantity(std::string_view text, std::string_view unit);

/// The factor from a display unit to SI: 1e-9 for "nm". The unit must be known (assert).
double unitFactor(std::string_view unit);

/// A number as short as reads back equal: "7 nm" for 7e-9, "m", "nm".
std::string formatQuantity(double value, std::string_view displayUnit);

/// A number in `displayUnit` as short as reads back equal to `value` in SI, without the unit.
std::string formatNumber(double value, std::string_view displayUnit = {});

} // namespace touchdown
