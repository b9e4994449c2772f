// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/pad_way.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

double padSeparation(const Case& c, double time)
{
    const double half = 0.5 * c.run.duration;
    const double share = std::min(std::abs(time - half) / half, 1.0); // 0 at the closest, 1 at both ends
    return share == 1.0 ? c.approach.start : c.approach.closest + share * (c.approach.start - c.approach.closest);
}

double approachTime(const Case& c, double separation)
{
    return 0.5 * c.run.duration * (c.approach.start - separation) / (c.approach.start - c.approach.closest);
}

double retractionTime(const Case& c, double separation) { return c.run.duration - approachTime(c, separation); }

std::vector<PadStation> padStations(const Case& c)
{
    const double duration = c.run.duration, interval = c.run.sampleInterval;
    const double slack = 1e-9 * interval;
    std::vector<PadStation> list(static_cast<std::size_t>(std::floor(duration / interval + 1e-9)) + 1);
    for (std::size_t i = 0; i < list.size(); ++i)
        list[i] = {std::min(static_cast<double>(i) * interval, duration), true, false};
    if (list.back().time > duration - slack)
        list.back().time = duration;
    else
        list.push_back({duration, true, false});

    const auto snapshots = static_cast<std::size_t>(c.run.fieldSnapshots);
    const std::size_t count = list.size();
    for (std::size_t i = 0; i < std::min(snapshots, count); ++i)
        list[snapshots == 1 ? 0 : i * (count - 1) / (std::min(snapshots, count) - 1)].snapshot = true;
    // The closest approach is a state of its own where no sample falls onto it.
    const double middle = 0.5 * duration;
    const auto next =
        std::ranges::find_if(list, [&](const PadStation& station) { return station.time > middle - slack; });
    if (next != list.end() && next->time < middle + slack) {
        next->time = middle;
        next->snapshot = snapshots > 0;
    } else {
        list.insert(next, {middle, false, snapshots > 0});
    }
    return list;
}

} // namespace touchdown
