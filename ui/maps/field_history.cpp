// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/field_history.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/style/unnamed_file.h"

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
    onDisk.emplace_back();
    extremes.push_back(std::move(own));
    if (snapshots.size() * values <= capacity) return;
    stride *= 2;
    std::size_t held = 0;
    for (std::size_t i = 0; i < snapshots.size(); i += 2) {
        std::swap(extremes[held], extremes[i]);
        std::swap(onDisk[held], onDisk[i]);
        std::swap(snapshots[held++], snapshots[i]);
    }
    snapshots.resize(held);
    extremes.resize(held);
    onDisk.resize(held);
}

std::span<const double> FieldHistory::values(std::size_t index, std::size_t field) const
{
    const std::size_t cells = fields.grid.cells();
    if (onDisk[index]) return {onDisk[index].get() + field * cells, cells};
    return snapshots[index].values[field];
}

FieldSnapshot FieldHistory::snapshot(std::size_t index) const
{
    FieldSnapshot whole = snapshots[index];
    for (std::size_t field = 0; onDisk[index] && field < fields.quantities.size(); ++field) {
        const std::span<const double> stored = values(index, field);
        whole.values.emplace_back(stored.begin(), stored.end());
    }
    return whole;
}

void FieldHistory::moveToDisk(double time, std::shared_ptr<const double[]> values)
{
    for (std::size_t i = 0; i < snapshots.size(); ++i) {
        if (snapshots[i].time != time || onDisk[i]) continue;
        snapshots[i].values = {};
        onDisk[i] = std::move(values);
        return;
    }
}

void FieldHistory::letGo() const
{
    for (const auto& each : onDisk)
        if (each) touchdown::letGo({each.get(), fields.quantities.size() * fields.grid.cells()});
}

std::size_t FieldHistory::bytesInMemory() const
{
    std::size_t numbers = 0;
    for (const FieldSnapshot& snapshot : snapshots)
        for (const std::vector<double>& each : snapshot.values) numbers += each.size();
    return numbers * sizeof(double);
}

std::size_t FieldHistory::bytesOnDisk() const
{
    const auto count = static_cast<std::size_t>(std::ranges::count_if(onDisk, [](const auto& each) { return !!each; }));
    return count * fields.quantities.size() * fields.grid.cells() * sizeof(double);
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
