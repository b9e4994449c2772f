// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parameter of a study as its charts and sentences name it.
#pragma once

#include <string>

namespace touchdown {

struct DesignKey;

struct ParameterText {
    std::string label;              // "Static flying height"
    std::string inSentence() const; // "static flying height"
    std::string unit, displayUnit;
    /// A value with four digits and its unit.
    std::string of(double value) const;
};
ParameterText parameterText(const DesignKey& key);

} // namespace touchdown
