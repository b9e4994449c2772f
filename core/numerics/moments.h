// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

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

/// The mean of the two middle values of an even number; 0 of none.
inline double medianOf(std::vector<double> values)
{
    if (values.empty()) return 0.0;
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

} // namespace touchdown
