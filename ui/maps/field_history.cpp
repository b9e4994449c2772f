// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/field_history.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchdown {

void FieldHistory::add(const FieldSnapshot& snapshot)
{
    std::size_t values = 0;
    for (std::size_t i = 0; i < snapshot.values.size(); ++i) {
        values += snapshot.values[i].size();
        if (snapshot.values[i].empty()) continue;
        const auto [low, high] = std::ranges::minmax(snapshot.values[i]);
        if (i == ranges.size())
            ranges.push_back({low, high});
        else
            ranges[i] = {std::min(ranges[i].low, low), std::max(ranges[i].high, high)};
    }
    if (arrived++ % stride != 0) return;
    snapshots.push_back(snapshot);
    if (snapshots.size() * values <= capacity) return;
    stride *= 2;
    std::size_t held = 0;
    for (std::size_t i = 0; i < snapshots.size(); i += 2) std::swap(snapshots[held++], snapshots[i]);
    snapshots.resize(held);
}

std::size_t FieldHistory::nearest(double time) const
{
    const auto found =
        std::ranges::min_element(snapshots, {}, [time](const FieldSnapshot& s) { return std::abs(s.time - time); });
    return static_cast<std::size_t>(found - snapshots.begin());
}

} // namespace touchdown
