// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbered parts of a rail in a sentence.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace touchdown {

/// "point 3", "points 3, 4 and 5", or "points 3, 4, 5, 6 and 7 more" for long lists; counted from 1, from indices.
std::string partList(const std::string& name, const std::vector<std::size_t>& indices);

} // namespace touchdown
