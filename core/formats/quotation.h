// SPDX-License-Identifier: GPL-3.0-or-later
//
// Input in a form that fits into a message: short, on one line, without control characters.
#pragma once

#include <string>
#include <string_view>

namespace touchdown {

/// Text that a terminal shows and does not obey: control characters (also those of the range C1), marks that turn the
/// direction of writing, and bytes that are no UTF-8 become "\u001b", "\u202e", "\x9b". Tabs stay; line breaks
/// stay with `severalLines`. JSON stays the same JSON.
std::string printable(std::string_view text, bool severalLines = false);

/// "7 nm" with its quotation marks; unprintable characters become '?', a long text ends with "...".
std::string inQuotes(std::string_view text);

/// The text without the pair of quotation marks, double or single, that encloses it, if there is one.
std::string_view withoutQuotes(std::string_view text);

/// Index of the first byte that is not valid UTF-8 (RFC 3629); npos if there is none.
std::size_t findInvalidUtf8(std::string_view text);

} // namespace touchdown
