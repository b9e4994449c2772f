// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/map_holes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "core/formats/decimal.h"

namespace touchdown {

namespace {

constexpr double beyondHeights = 1e29; // single precision ends at 3.4e38
constexpr double farOfAny = 1000.0;    // times the range of the others
constexpr double knownMarks[] = {-999.0,       999.0,         -999.25,      -999.9,       -9999.0,      -9999.9,
                                 -99999.0,     -999999.0,     9999.0,       99999.0,      999999.0,     -32768.0,
                                 32767.0,      -32767.0,      65535.0,      2147483640.0, 2147483646.0, 2147483647.0,
                                 2147483648.0, -2147483648.0, -2147483647.0};

bool isMark(double v) { return std::ranges::find(knownMarks, v) != std::end(knownMarks); }

/// Range and median of the heights that a test keeps.
struct Others {
    double range = 0.0, median = 0.0;
    bool any = false;

    template <typename Keep>
    Others(std::span<const double> heights, Keep keep)
    {
        std::vector<double> kept;
        std::ranges::copy_if(heights, std::back_inserter(kept), keep);
        if (kept.empty()) return;
        any = true;
        const auto [lowest, highest] = std::ranges::minmax_element(kept);
        range = *highest - *lowest;
        const auto middle = kept.begin() + static_cast<std::ptrdiff_t>(kept.size() / 2);
        std::ranges::nth_element(kept, middle);
        median = *middle;
    }
};

} // namespace

std::optional<std::size_t> findHole(std::span<const double> heights)
{
    if (heights.empty()) return std::nullopt;
    const auto beyond = std::ranges::find_if(heights, [](double v) { return std::abs(v) >= beyondHeights; });
    if (beyond != heights.end()) return static_cast<std::size_t>(beyond - heights.begin());

    if (std::ranges::any_of(heights, isMark)) {
        const Others others(heights, [](double v) { return !isMark(v); });
        const auto mark = std::ranges::find_if(
            heights, [&](double v) { return isMark(v) && others.any && std::abs(v - others.median) > others.range; });
        if (mark != heights.end()) return static_cast<std::size_t>(mark - heights.begin());
    }
    const std::ranges::minmax_result<double> ends = std::ranges::minmax(heights);
    const double lowest = ends.min, highest = ends.max;
    const Others others(heights, [=](double v) { return v != lowest && v != highest; });
    for (const double v : {lowest, highest})
        if (others.range > 0.0 && std::abs(v - others.median) > farOfAny * others.range)
            return static_cast<std::size_t>(std::ranges::find(heights, v) - heights.begin());
    return std::nullopt;
}

std::string holeText(double height)
{
    return "a surface has no holes: " + decimalText(height) +
           " is far from the other heights and marks a missing point";
}

} // namespace touchdown
