// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace touchdown {

/// A closed interval of a switching quantity, where one smooth law holds; unbounded by default.
struct Interval {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
};

} // namespace touchdown
