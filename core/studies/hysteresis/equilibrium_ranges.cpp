// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis/equilibrium_ranges.h"

#include <algorithm>
#include <numeric>

namespace touchdown {

std::vector<ValueRange> rangesAlong(const std::vector<EquilibriumLine>& lines,
                                    const std::function<bool(const StudiedEquilibrium&)>& isSo)
{
    const auto is = [&](const StudiedEquilibrium& at) { return !at.edge && isSo(at); };
    std::vector<ValueRange> ranges;
    for (const EquilibriumLine& line : lines) {
        if (line.outside) continue;
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            if (!is(line.points[i])) continue;
            const std::size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, line.points.size() - 1);
            ValueRange range{line.points[i].value, line.points[i].value};
            for (const std::size_t k : {before, after}) {
                const StudiedEquilibrium& next = line.points[k];
                if (!is(next) && !next.edge) continue;
                range = {std::min(range.lower, next.value), std::max(range.upper, next.value)};
            }
            ranges.push_back(range);
        }
    }
    return merged(std::move(ranges));
}

std::vector<ValueRange> coexistence(const std::vector<EquilibriumLine>& lines)
{
    std::vector<double> ends;
    for (const EquilibriumLine& line : lines)
        for (const StudiedEquilibrium& at : line.points) ends.push_back(at.value);
    std::ranges::sort(ends);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const auto rests = [](const EquilibriumAt& at) {
        return !at.outside && !at.incomplete &&
               (at.stability == Stability::Stable || at.stability == Stability::Neutral);
    };
    std::vector<ValueRange> ranges;
    for (std::size_t i = 1; i < ends.size(); ++i)
        if (std::ranges::count_if(equilibriaAt(lines, std::midpoint(ends[i - 1], ends[i])), rests) > 1)
            ranges.push_back({ends[i - 1], ends[i]});
    ranges = merged(std::move(ranges));
    // Where one line ends and the next begins they may overlap by rounding.
    std::erase_if(ranges, [&](const ValueRange& range) {
        return range.upper - range.lower <= rangesMeet * (ends.back() - ends.front());
    });
    return ranges;
}

} // namespace touchdown
