// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers with their units, rows and paragraphs of the reports of the terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace touchdown {

/// 1.234e-3 in "ms": "1.234 ms", with so many significant digits; trailing zeros are left out.
std::string displayed(double value, const std::string& displayUnit, int digits = 4);
/// The same with trailing zeros, which show the precision; "-" for a value that is not finite.
std::string displayedInFull(double value, const std::string& displayUnit, int digits = 5);
/// A number in SI at the right end of a column of 14 characters.
std::string numberColumn(double value, int digits);

/// "not converged: why". A message that begins with the status is enough.
std::string statusText(std::string_view status, const std::string& message);

/// The name, and the value in a column of its own; ends with a line break.
std::string reportRow(const std::string& name, const std::string& value);

/// Indented lines of at most `width` characters; each ends with a line break.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width = 100);
/// With spaces up to the width, and two more.
std::string padded(const std::string& text, std::size_t width);

} // namespace touchdown
