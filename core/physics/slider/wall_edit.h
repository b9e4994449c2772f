// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an editor does to the points of a wall profile. The distances ascend before and after; a profile keeps two
// points or more. Points count from 0. Places that change are rounded to 1e-15 m.
#pragma once

#include <cstddef>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

/// The point at this distance and recess [m], its distance kept between those of its neighbours.
WallProfile movedWallPoint(WallProfile wall, std::size_t point, double distance, double recess);

/// A point on the profile at this distance [m]; beyond an end, with the recess of that end.
WallProfile withWallPoint(WallProfile wall, double distance);
/// Where a new point after this one begins: in the middle of the piece that follows; after the last point as far from
/// it as the one before is [m].
double distanceAfter(const WallProfile& wall, std::size_t point);
/// The index of the point that withWallPoint adds at this distance.
std::size_t placeOfPoint(const WallProfile& wall, double distance);

/// Unchanged where only two points are left.
WallProfile withoutWallPoint(WallProfile wall, std::size_t point);

/// The profile that a new wall begins with: 10 um wide, from this recess to that of the base [m].
WallProfile slopedWall(double from, double to);

} // namespace touchdown
