// SPDX-License-Identifier: GPL-3.0-or-later
//
// Encodings in which instruments write text.
#pragma once

#include <string>

namespace touchdown {

/// The text in UTF-8, without a byte order mark. UTF-16 of either byte order is recognised by its mark; text without a
/// mark stays as it is.
std::string asUtf8(std::string text);

} // namespace touchdown
