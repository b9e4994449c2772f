// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers in the sentences of a study: as many digits as they are worth.
#pragma once

#include <string>

namespace touchdown {

/// Rounded to `digits` significant ones; 0 stays 0.
double roundedTo(double value, int digits);
/// "3.1e-6 nm", "15"; without a unit where that is empty.
std::string fewDigits(double value, const std::string& displayUnit, int digits = 2);
/// In s, ms, us or ns, whichever reads best.
std::string fewDigitsOfTime(double seconds, int digits = 2);

} // namespace touchdown
