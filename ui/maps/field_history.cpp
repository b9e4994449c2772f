// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/field_history.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchdown {

void FieldHistory::add(const FieldSnapshot& snapshot)
{
    std::size_t values = 0;
    std::vector<PlotRange> own(snapshot.values.size());
    for (std::size_t i = 0; i < snapshot.values.size(); ++i) {
        values += snapshot.values[i].size();
        if (snapshot.values[i].empty()) continue;
        const auto [low, high] = std::ranges::minmax(snapshot.values[i]);
        own[i] = {low, high};
        if (i == ranges.size())
            ranges.push_back({low, high});
        else
            ranges[i] = {std::min(ranges[i].low, low), std::max(ranges[i].high, high)};
    }
    if (arrived++ % stride != 0) return;
    snapshots.push_back(snapshot);
    extremes.push_back(std::move(own));
    if (snapshots.size() * values <= capacity) return;
    stride *= 2;
    std::size_t held = 0;
    for (std::size_t i = 0; i < snapshots.size(); i += 2) {
        std::swap(extremes[held], extremes[i]);
        std::swap(snapshots[held++], snapshots[i]);
    }
    snapshots.resize(held);
    extremes.resize(held);
}

PlotRange FieldHistory::usualRange(std::size_t field) const
{
    constexpr std::size_t fewest = 10;
    const PlotRange& whole = ranges[field];
    if (extremes.size() < fewest) return whole;
    std::vector<double> lows, highs;
    for (const std::vector<PlotRange>& each : extremes) {
        lows.push_back(each[field].low);
        highs.push_back(each[field].high);
    }
    const auto tenth = static_cast<std::ptrdiff_t>(extremes.size() / 10);
    std::ranges::nth_element(lows, lows.begin() + tenth);
    std::ranges::nth_element(highs, highs.end() - 1 - tenth);
    const double low = lows[static_cast<std::size_t>(tenth)], high = *(highs.end() - 1 - tenth), span = high - low;
    if (!(span > 0.0)) return whole; // as without contact most of the time
    return {whole.low < low - span ? low : whole.low, whole.high > high + span ? high : whole.high};
}

std::size_t FieldHistory::nearest(double time) const
{
    const auto found =
        std::ranges::min_element(snapshots, {}, [time](const FieldSnapshot& s) { return std::abs(s.time - time); });
    return static_cast<std::size_t>(found - snapshots.begin());
}

} // namespace touchdown
