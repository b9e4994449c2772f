// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts in lines that fit.
#pragma once

#include <cstddef>
#include <string>

namespace touchdown {

/// Lines of at most `width` characters, all indented, the last one ended, too.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width = 100);

/// With spaces up to the width, and two more.
std::string padded(const std::string& text, std::size_t width);

} // namespace touchdown
