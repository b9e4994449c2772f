// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers that stand for missing heights.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace touchdown {

/// The first height, as the file writes it, that marks a missing point: 1e29 or more; -9999, -32768, 2147483647 and
/// others that instruments use, farther from the median of the other heights than their range; any number more than
/// 1000 times that range from it.
std::optional<std::size_t> findHole(std::span<const double> heights);
/// Why a surface with this height is refused.
std::string holeText(double height);

} // namespace touchdown
