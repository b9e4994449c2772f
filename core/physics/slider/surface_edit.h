// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an editor does to an air bearing surface: functions from a surface to a changed one. They check nothing, so that
// a shape may pass through an impossible one while it is drawn (core/physics/slider/surface_check.h tells what is
// wrong); they keep the numbers that they do not change, bit for bit, and round places that they change to 1e-15 m.
// Rails, edges and corners count from 0; edge i runs from corner i to the next one. Kept distances and symmetries stay
// with their corners; one whose part is removed is removed, too. Nothing here solves them
// (core/physics/slider/surface_relations.h).
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

enum class PartKind : std::uint8_t { Rail, Edge, Corner, Interest, Distance, Symmetry };

/// A part of a surface that can be selected.
struct SurfacePart {
    PartKind kind = PartKind::Rail;
    std::size_t item = 0;  // rail, point of interest, kept distance or symmetry
    std::size_t index = 0; // edge or corner of the rail
    auto operator<=>(const SurfacePart&) const = default;
};
using PartSelection = std::set<SurfacePart>;

/// A rail, an edge or a corner: `item` is a rail.
bool isOfRail(const SurfacePart& part);

/// Whether the surface has this part.
bool has(const AirBearingSurface& surface, const SurfacePart& part);

/// To 1e-15 m, so that a place has few digits in a file.
double tidy(double place);

/// A direction and a distance along x and y [m].
struct SurfaceShift {
    double x = 0.0, y = 0.0;
};

/// Rails, corners and points of interest are moved; of an edge both corners are. A single edge is moved parallel to
/// itself, by the part of the shift that is normal to it, and its corners slide along the neighbouring edges.
AirBearingSurface moved(AirBearingSurface surface, const PartSelection& parts, SurfaceShift by);

/// The unit vector normal to an edge that exists, to the right of its direction [-].
SurfaceShift edgeNormal(const AirBearingSurface& surface, const SurfacePart& edge);

/// A corner at this place on an edge, which is parted there; both halves have its wall. A ramp keeps its plane.
AirBearingSurface withCorner(AirBearingSurface surface, std::size_t rail, std::size_t edge, SurfacePoint at);

/// Without these parts. The edges before and after a removed corner become one, with the wall of the edge before; of
/// an edge its second corner is removed. A rail that would have fewer than three corners is removed. A ramp keeps its
/// plane.
AirBearingSurface without(AirBearingSurface surface, const PartSelection& parts);

/// With copies of these rails on top, moved; they are the last ones in the list.
AirBearingSurface withCopies(AirBearingSurface surface, const PartSelection& parts, SurfaceShift by);

/// Rails and points of interest mirrored about the centre line of a slider of this width [m].
AirBearingSurface mirrored(AirBearingSurface surface, const PartSelection& parts, double width);

/// The rail at another place in the order of overlap; those between move by one place.
AirBearingSurface reordered(AirBearingSurface surface, std::size_t rail, std::size_t place);

/// Without a wall profile: edges that have it become vertical, and those that have a later one keep theirs.
AirBearingSurface withoutWall(AirBearingSurface surface, std::size_t wall);

/// The image of a rail in the centre line.
struct MirrorImage {
    std::size_t rail = 0;
    std::vector<std::size_t> corner; // of the image, for each corner of the rail
};
/// For each rail the rail that is its mirror image, perhaps itself, where all corners agree within `reach` [m] and the
/// recesses are the same.
std::vector<std::optional<MirrorImage>> mirrorImages(const AirBearingSurface& surface, double width, double reach);

/// As `moved`, and the images of the parts move as the mirror shows it. A rail that is its own image stays one: its
/// corners on both sides move, and along y a whole rail does not. A rail in `single`, and its image, move alone.
AirBearingSurface movedInPairs(const AirBearingSurface& surface, const PartSelection& parts, SurfaceShift by,
                               double width, double reach, const std::set<std::size_t>& single = {});

/// Without the wall profiles that no edge has.
AirBearingSurface withoutUnusedWalls(AirBearingSurface surface);

/// With this wall on these edges, and on all edges of these rails; 0: none, vertical edges.
AirBearingSurface withEdgeWall(AirBearingSurface surface, const PartSelection& parts, int wall);

/// What a point that is dragged snaps to, along one axis.
enum class SnapTarget : std::uint8_t { None, Raster, Centre, Border, Corner };
struct SnappedPlace {
    SurfacePoint at;                        // [m]
    SnapTarget x = SnapTarget::None, y = x; // what held it
    SurfacePart xCorner{}, yCorner{};       // that one, where it was a corner
};
struct SnapGrid {
    double length = 0.0, width = 0.0; // of the slider [m]
    double reach = 0.0;               // within which it snaps [m]
    double raster = 0.0;              // [m]; 0: none
};
/// The place itself or one nearby: with the x or the y of a corner that does not move, or of the slider's border or
/// centre line, else on the raster.
SnappedPlace snapped(const AirBearingSurface& surface, const PartSelection& moving, SurfacePoint at,
                     const SnapGrid& grid);

} // namespace touchdown
