// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rails as the window draws them: polygons, where their numbers stand, which one lies under a point, and the levels of
// recess that their colours step through.
#pragma once

#include <optional>
#include <vector>

#include <QPointF>
#include <QPolygonF>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

/// Of a point from the line between two others.
double distanceToEdge(const QPointF& point, const QPointF& a, const QPointF& b);

/// The corners in m, x to the right and y upwards.
QPolygonF railPolygon(const Rail& rail);

/// The rail whose top is seen at a point: the last in the list that holds it; nothing on the base.
std::optional<std::size_t> railAt(const AirBearingSurface& surface, const SurfacePoint& point);

/// Where each rail's number stands: inside it, far from its edges and, if it can be, not under a later rail.
std::vector<SurfacePoint> railNumberPoints(const AirBearingSurface& surface);

/// The different recesses of tops and base, ascending; at most `most`, of which the ends stay.
std::vector<double> recessLevels(const AirBearingSurface& surface, std::size_t most = 8);

} // namespace touchdown
