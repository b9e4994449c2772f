// SPDX-License-Identifier: GPL-3.0-or-later
//
// Relations that a shape keeps through every edit: distances and mirror images (core/physics/slider/
// air_bearing_surface.h). Along each axis they are equations of two numbers, x_b = x_a + value or y_b = width - y_a, so
// that corners are tied in groups of one free number each (core/physics/slider/tied_numbers.h). The free numbers follow
// from wishes, which are granted in this order where they contradict neither relations nor earlier wishes:
//
//   1  parts that were just moved keep their shape, then their place
//   2  other rails keep their shape: they follow as a whole
//   3  other corners of the rails of the moved parts stay
//   4  other rails stay
//
// A number that the wishes do not change keeps its bits; others are rounded to 1e-15 m. Relations bind outlines: a
// recess or a wall is not mirrored. The pressure does not depend on relations.
#pragma once

#include <optional>
#include <vector>

#include "core/physics/slider/surface_check.h"
#include "core/physics/slider/surface_edit.h"

namespace touchdown {

/// The shape with its relations, on a slider of this width [m], where corners or whole rails of `kept` were just moved.
/// Rails that no relation connects to `kept` stay as drawn; all do where relations of the others contradict each other.
/// Mirror images are found corner by corner in `before`, where the numbers of corners are the same.
AirBearingSurface solved(const AirBearingSurface& drawn, const PartSelection& kept, double width,
                         const AirBearingSurface& before);

/// Every edit of an editor passes through this: what differs from the surface before is kept, and the relations are
/// solved. Relations without their parts are removed. An edit that changes the relations themselves moves nothing.
AirBearingSurface keepingRelations(const AirBearingSurface& before, AirBearingSurface after, double width);

/// Relations that the shape does not obey, or that contradict those before them: symmetries first, then distances.
std::vector<SurfaceProblem> relationProblems(const AirBearingSurface& surface, double width);

/// Whether rails and corners of the relation exist, and two mirror images have as many corners.
bool exists(const AirBearingSurface& surface, const KeptDistance& distance);
bool exists(const AirBearingSurface& surface, const KeptSymmetry& symmetry);

/// The middle of an edge, or the corner.
SurfacePoint middleOf(const AirBearingSurface& surface, const RailPlace& place);

/// The distance between two parts of rails as it is drawn, not negative; a rail stands for its nearest edge, an edge
/// must be upright to the axis. Nothing where there is none, or where it is the place itself.
std::optional<KeptDistance> drawnDistance(const AirBearingSurface& surface, const PartSelection& parts, bool alongX);

/// With another value of a kept distance [m]; `to` moves.
AirBearingSurface withDistance(AirBearingSurface surface, std::size_t distance, double value, double width);

/// With one more symmetry; the image follows the rail.
AirBearingSurface withSymmetry(AirBearingSurface surface, const KeptSymmetry& symmetry, double width);

} // namespace touchdown
