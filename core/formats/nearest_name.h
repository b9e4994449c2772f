// SPDX-License-Identifier: GPL-3.0-or-later
//
// The name that was most likely meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

/// The nearest of `names` by letters inserted, deleted, replaced or swapped (Damerau 1964), at most `most`; "" if none
/// is as near.
std::string nearestName(std::string_view name, const std::vector<std::string>& names, std::size_t most);

/// The same, with the slips that a word of its length allows.
std::string nearestName(std::string_view name, const std::vector<std::string>& names);

/// "; did you mean NAME?", or nothing when there is no name.
std::string didYouMean(const std::string& name);

} // namespace touchdown
