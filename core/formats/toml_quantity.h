// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers with units as a case file holds them: a bare number in SI, or a text with its unit.
#pragma once

#include "core/formats/toml_document.h"
#include "core/formats/units.h"

#include <string>
#include <string_view>
#include <variant>

namespace touchdown {

/// 7e-9, 1 or "7 nm" as a finite number in `unit`; a problem says what is needed, for example "a number or \"1 nm\"".
std::variant<double, UnitProblem> tomlQuantity(const TomlValue& value, std::string_view unit,
                                               std::string_view displayUnit);

/// A number as a case file writes it: "\"7 nm\"", or bare where the display unit is "" or cannot give it.
std::string formatTomlQuantity(double value, std::string_view displayUnit);

} // namespace touchdown
