// SPDX-License-Identifier: GPL-3.0-or-later
//
// The series of static states that a case lists, and what of their results is kept.
#include "core/simulation/static_state/steady.h"

namespace touchdown {

std::vector<SteadySeriesPoint> seriesOf(const Case& c)
{
    const auto listed = [](const std::vector<double>& list, double alone) {
        return list.empty() ? std::vector<double>{alone} : list;
    };
    const std::vector<double> radii = listed(c.steady.radii, c.disk.radius);
    const std::vector<double> speeds = listed(c.steady.speeds, c.disk.speed);
    std::vector<std::optional<double>> altitudes(c.steady.altitudes.begin(), c.steady.altitudes.end());
    if (altitudes.empty()) altitudes.emplace_back();

    std::vector<SteadySeriesPoint> series;
    for (const auto& altitude : altitudes)
        for (const double speed : speeds)
            for (std::size_t i = 0; i < radii.size(); ++i)
                series.push_back(
                    {radii[i], i < c.steady.skews.size() ? c.steady.skews[i] : c.disk.skew, speed, altitude});
    return series;
}

Case withoutSeries(Case c)
{
    c.steady.radii.clear();
    c.steady.skews.clear();
    c.steady.speeds.clear();
    c.steady.altitudes.clear();
    return c;
}

Case caseAt(const Case& c, const SteadySeriesPoint& point)
{
    Case at = withoutSeries(c);
    at.disk.radius = point.radius;
    at.disk.skew = point.skew;
    at.disk.speed = point.speed;
    if (point.altitude) {
        at.air.source = AirSource::Atmosphere;
        at.air.altitude = *point.altitude;
    }
    return at;
}

} // namespace touchdown
