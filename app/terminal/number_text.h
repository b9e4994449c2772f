// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers with their units in the reports of the terminal.
#pragma once

#include <string>

namespace touchdown {

/// 1.234e-3 in "ms": "1.234 ms", with so many significant digits.
std::string displayed(double value, const std::string& displayUnit, int digits = 4);

} // namespace touchdown
