// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words: taken from a text, and put into a message.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

inline constexpr std::string_view blanks = " \t"; // within a line

/// The text without these characters at both ends.
std::string_view trimmed(std::string_view text, std::string_view characters = " \t\r\n");

/// ASCII letters only.
std::string lowerCase(std::string_view text);

/// With a capital first letter.
std::string capitalized(std::string text);
/// With a small first letter, as within a sentence; "ABS" stays.
std::string uncapitalized(std::string text);

std::string joined(const std::vector<std::string>& words, std::string_view between = ", ");

/// "1 rail", "2 rails".
std::string counted(std::size_t count, std::string_view noun);

} // namespace touchdown
