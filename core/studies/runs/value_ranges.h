// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parameter of a study as its charts and sentences name it, and ranges of its values.
#pragma once

#include <string>
#include <vector>

namespace touchdown {

struct Parameter;

struct ParameterText {
    std::string label; // "Static flying height"
    std::string unit, displayUnit;
    /// A value with four digits and its unit.
    std::string of(double value) const;
};
ParameterText parameterText(const Parameter& key);

struct ValueRange {
    double lower = 0.0, upper = 0.0; // [unit of the parameter]
};

/// Ranges meet where their distance is below this share of the whole range [-].
inline constexpr double rangesMeet = 1e-6;

/// Sorted by their lower ends; ranges that meet are joined.
std::vector<ValueRange> merged(std::vector<ValueRange> ranges);

/// The ranges of `chosen` among all values; neighbours are one range.
std::vector<ValueRange> rangesAmong(std::vector<double> all, std::vector<double> chosen);

/// "at 3 nm", "from 3 nm to 5 nm and at 8 nm".
std::string text(const std::vector<ValueRange>& ranges, const ParameterText& parameter);

} // namespace touchdown
