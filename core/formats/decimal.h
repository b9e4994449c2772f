// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decimal numbers as text, whose exponent can be shifted, so that a change of unit by a power of ten rounds nothing.
// The decimal point is a point, whatever the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace touchdown {

/// number * 10^decade, rounded once; nothing when it is no decimal number or beyond the range of doubles.
std::optional<double> readDecimal(std::string_view number, int decade = 0);

/// value * 10^decade as people write it: "7", "0.25", "1.35e6"; `value` finite. Without `digits` the shortest text that
/// reads back as the same number, with it that many significant ones.
std::string decimalText(double value, int decade = 0, std::optional<int> digits = {});

} // namespace touchdown
