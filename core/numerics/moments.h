// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <span>

namespace touchdown {

struct Moments {
    double mean = 0.0, deviation = 0.0; // standard deviation of the values themselves: over n, not n - 1
};

/// Of one value or more; about the mean, which round-off cannot cancel.
inline Moments momentsOf(std::span<const double> values)
{
    const double count = static_cast<double>(values.size()), first = values.front();
    double sum = 0.0, squares = 0.0;
    for (const double value : values) sum += value - first;
    const double mean = first + sum / count;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares / count)};
}

} // namespace touchdown
