// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/lift_area.h"

#include <algorithm>

namespace touchdown {

bool railsSurround(const AirBearingSurface& surface, SurfacePoint load, bool rollHeld)
{
    constexpr double carryingBase = 0.5e-6; // below the highest rail [m]
    double highest = surface.baseRecess;    // least recess [m]
    std::vector<SurfacePoint> corners;
    for (const Rail& rail : surface.rails) {
        const std::size_t levels = rail.kind == RailKind::Ramp ? rail.recess.size() : 1;
        const auto end = rail.recess.begin() + static_cast<std::ptrdiff_t>(levels);
        const double least = *std::min_element(rail.recess.begin(), end);
        highest = std::min(highest, least);
        if (least < surface.baseRecess)
            for (const RailPoint& point : rail.points) corners.push_back({point.x, point.y});
    }
    if (surface.baseRecess - highest < carryingBase) return true;
    if (rollHeld) {
        const auto [first, last] = std::ranges::minmax(corners, {}, &SurfacePoint::x);
        return first.x <= load.x && load.x <= last.x;
    }
    // Within the hull no line through the point has all corners on one side. Such a line, if there is one, can be
    // turned until it meets a corner.
    return std::ranges::none_of(corners, [&](const SurfacePoint& on) {
        const double x = on.x - load.x, y = on.y - load.y;
        bool left = false, right = false, behind = false; // of the ray from the load through `on`: a corner is there
        for (const SurfacePoint& corner : corners) {
            const double cx = corner.x - load.x, cy = corner.y - load.y;
            const double side = x * cy - y * cx;
            left = left || side > 0.0;
            right = right || side < 0.0;
            behind = behind || (side == 0.0 && x * cx + y * cy <= 0.0);
        }
        return !behind && !(left && right);
    });
}

} // namespace touchdown
