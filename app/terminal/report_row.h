// SPDX-License-Identifier: GPL-3.0-or-later
//
// A row of a report for people.
#pragma once

#include <algorithm>
#include <string>

namespace touchdown {

/// The name, and the value in a column of its own; ends with a line break.
inline std::string reportRow(const std::string& name, const std::string& value)
{
    constexpr std::size_t width = 22;
    return name + std::string(width - std::min(width - 1, name.size()), ' ') + value + "\n";
}

} // namespace touchdown
