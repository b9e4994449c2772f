// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which part of a surface lies under the pointer, and how a selection reads.
#pragma once

#include <optional>

#include <QPointF>
#include <QRectF>
#include <QString>

#include "core/physics/slider/surface_edit.h"

namespace touchdown {

class SliderPlan;

/// The nearest corner or point of interest within 8 px, else a kept distance, else the nearest edge within 5 px, else
/// the top that is seen. Parts of rails in `preferred` come before those of others.
std::optional<SurfacePart> partAt(const SliderPlan& plan, const AirBearingSurface& surface, const QPointF& pixel,
                                  const PartSelection& preferred);

/// What lies in a rectangle [m]: rails that are whole in it; where there is none, corners; and points of interest.
PartSelection partsWithin(const AirBearingSurface& surface, const QRectF& area);

/// The rails of these parts; points of interest have none.
PartSelection railsOf(const PartSelection& parts);

/// The rails with these numbers after another edit: an equal rail, else one that has kept its number while none was
/// added or removed.
std::set<std::size_t> sameRails(const AirBearingSurface& before, const AirBearingSurface& after,
                                const std::set<std::size_t>& rails);

/// "rail 3", "corner 2 of rail 3", "5 parts".
QString partText(const SurfacePart& part);
QString selectionText(const PartSelection& parts);

/// "rail 2 stays 80 µm from rail 1 along y", or with its edges and corners where `whole`; "rails 1 and 2 stay mirror
/// images".
QString relationText(const AirBearingSurface& surface, const SurfacePart& relation, bool whole);

/// What holds a place that snaps: "corner 2 of rail 3", "centre line", "border"; empty for the raster or nothing.
QString snapText(SnapTarget target, const SurfacePart& corner);

/// As snapped(), but the nearest of these places within reach comes first.
SnappedPlace snappedTo(const std::vector<SurfacePoint>& places, const AirBearingSurface& surface,
                       const PartSelection& moving, SurfacePoint at, const SnapGrid& grid);

/// The place of a corner, of an edge's first corner, of a point of interest, or of a relation; of a rail the corner
/// nearest to `near`.
SurfacePoint placeOf(const AirBearingSurface& surface, const SurfacePart& part, SurfacePoint near);

/// The ends of an edge that alone is selected; else the selected corners and points of interest.
std::vector<SurfacePoint> placesToMeasure(const AirBearingSurface& surface, const PartSelection& parts);

/// The place on an edge that exists nearest to `near`, rounded to the raster; 0: none [m].
SurfacePoint placeOnEdge(const AirBearingSurface& surface, const SurfacePart& edge, SurfacePoint near, double raster);

} // namespace touchdown
