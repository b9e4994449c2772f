// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/wall_edit.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

namespace {

double rounded(double place)
{
    constexpr double perMetre = 1e15;
    return std::round(place * perMetre) / perMetre;
}

} // namespace

WallProfile movedWallPoint(WallProfile wall, std::size_t point, double distance, double recess)
{
    if (point >= wall.distance.size()) return wall;
    if (distance != wall.distance[point]) distance = rounded(distance);
    if (recess != wall.recess[point]) recess = rounded(recess);
    if (point > 0) distance = std::max(distance, wall.distance[point - 1]);
    if (point + 1 < wall.distance.size()) distance = std::min(distance, wall.distance[point + 1]);
    wall.distance[point] = distance;
    wall.recess[point] = recess;
    return wall;
}

std::size_t placeOfPoint(const WallProfile& wall, double distance)
{
    return static_cast<std::size_t>(std::ranges::upper_bound(wall.distance, distance) - wall.distance.begin());
}

WallProfile withWallPoint(WallProfile wall, double distance)
{
    const std::size_t place = placeOfPoint(wall, distance);
    double recess = place == 0 ? wall.recess.front() : wall.recess.back();
    if (place > 0 && place < wall.distance.size()) {
        const double from = wall.distance[place - 1], to = wall.distance[place];
        recess = std::lerp(wall.recess[place - 1], wall.recess[place], (distance - from) / (to - from));
    }
    const auto at = static_cast<std::ptrdiff_t>(place);
    wall.distance.insert(wall.distance.begin() + at, rounded(distance));
    wall.recess.insert(wall.recess.begin() + at, rounded(recess));
    return wall;
}

double distanceAfter(const WallProfile& wall, std::size_t point)
{
    if (point + 1 < wall.distance.size()) return 0.5 * (wall.distance[point] + wall.distance[point + 1]);
    return 2.0 * wall.distance.back() - wall.distance[wall.distance.size() - 2];
}

WallProfile withoutWallPoint(WallProfile wall, std::size_t point)
{
    if (wall.distance.size() <= 2 || point >= wall.distance.size()) return wall;
    wall.distance.erase(wall.distance.begin() + static_cast<std::ptrdiff_t>(point));
    wall.recess.erase(wall.recess.begin() + static_cast<std::ptrdiff_t>(point));
    return wall;
}

WallProfile slopedWall(double from, double to)
{
    constexpr double width = 10e-6; // [m]
    return {{0.0, width}, {from, to}};
}

} // namespace touchdown
