// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/series_points.h"

#include <algorithm>
#include <numbers>

#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr double skewAside = 10.0 * std::numbers::pi / 180.0; // [rad]
constexpr double highestAltitude = 3000.0;                    // [m]

double clamped(const char* key, double value)
{
    const Parameter* parameter = findParameter(key);
    return std::clamp(value, parameter->minimum, parameter->maximum);
}

double between(double from, double to, double share) { return from + (to - from) * share; }

/// The ends of a list with more than one number.
void takeList(const std::vector<double>& list, SeriesChoice& choice)
{
    if (list.size() < 2) return;
    const auto [low, high] = std::ranges::minmax(list);
    if (!(high > low)) return;
    choice.from = low;
    choice.to = high;
}

} // namespace

bool hasLists(const Case& c) { return seriesOf(c).size() > 1; }

SeriesChoice usualChoice(const Case& c, Varied varied)
{
    SeriesChoice choice{.varied = varied, .skewFrom = c.disk.skew, .skewTo = c.disk.skew};
    switch (varied) {
    case Varied::Radius:
        choice.from = clamped("disk.radius", 0.5 * c.disk.radius);
        choice.to = clamped("disk.radius", 1.5 * c.disk.radius);
        takeList(c.steady.radii, choice);
        if (c.steady.skews.size() == c.steady.radii.size() && !c.steady.skews.empty()) {
            const auto [low, high] = std::ranges::minmax_element(c.steady.radii);
            choice.skewFrom = c.steady.skews[static_cast<std::size_t>(low - c.steady.radii.begin())];
            choice.skewTo = c.steady.skews[static_cast<std::size_t>(high - c.steady.radii.begin())];
        }
        break;
    case Varied::Skew:
        choice.from = clamped("disk.skew", c.disk.skew - skewAside);
        choice.to = clamped("disk.skew", c.disk.skew + skewAside);
        takeList(c.steady.skews, choice);
        break;
    case Varied::Speed:
        choice.from = clamped("disk.speed", 0.5 * c.disk.speed);
        choice.to = clamped("disk.speed", 1.5 * c.disk.speed);
        takeList(c.steady.speeds, choice);
        break;
    case Varied::Altitude:
        choice.to = highestAltitude;
        takeList(c.steady.altitudes, choice);
        break;
    case Varied::Lists: break;
    }
    return choice;
}

std::vector<SteadySeriesPoint> pointsOf(const Case& c, const SeriesChoice& choice)
{
    if (choice.varied == Varied::Lists) return seriesOf(c);
    std::vector<SteadySeriesPoint> points;
    const int last = std::max(1, choice.states - 1);
    for (int i = 0; i <= last; ++i) {
        const double share = static_cast<double>(i) / last;
        const double value = between(choice.from, choice.to, share);
        SteadySeriesPoint point{c.disk.radius, c.disk.skew, c.disk.speed, {}};
        if (choice.varied == Varied::Radius) {
            point.radius = value;
            point.skew = between(choice.skewFrom, choice.skewTo, share);
        }
        if (choice.varied == Varied::Skew) point.skew = value;
        if (choice.varied == Varied::Speed) point.speed = value;
        if (choice.varied == Varied::Altitude) point.altitude = value;
        points.push_back(point);
    }
    return points;
}

double valueOf(const SteadySeriesPoint& point, Varied varied)
{
    switch (varied) {
    case Varied::Skew: return point.skew;
    case Varied::Speed: return point.speed;
    case Varied::Altitude: return point.altitude.value_or(0.0);
    default: return point.radius;
    }
}

Varied axisOf(std::span<const SteadySeriesPoint> points)
{
    for (const Varied varied : {Varied::Radius, Varied::Skew, Varied::Speed, Varied::Altitude})
        for (const SteadySeriesPoint& point : points)
            if (valueOf(point, varied) != valueOf(points.front(), varied)) return varied;
    return Varied::Radius;
}

Quantity quantityOf(Varied varied)
{
    switch (varied) {
    case Varied::Skew: return {"skew", "rad", "deg", "Skew"};
    case Varied::Speed: return {"speed", "rad/s", "rpm", "Speed of the disk"};
    case Varied::Altitude: return {"altitude", "m", "m", "Altitude"};
    default: return {"radius", "m", "mm", "Radius of the track"};
    }
}

QString curveName(const SteadySeriesPoint& point, std::span<const SteadySeriesPoint> points)
{
    const Varied axis = axisOf(points);
    QStringList parts;
    for (const Varied varied : {Varied::Speed, Varied::Altitude}) {
        const auto same = [&](const SteadySeriesPoint& other) {
            return valueOf(other, varied) == valueOf(points.front(), varied);
        };
        if (varied != axis && !std::ranges::all_of(points, same))
            parts << roundedText(valueOf(point, varied), quantityOf(varied).displayUnit, 6);
    }
    return parts.join(QStringLiteral(", "));
}

} // namespace touchdown
