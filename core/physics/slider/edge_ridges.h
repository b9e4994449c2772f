// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ridges along the edges of rails. A wall profile counts from the zero plane, not from its rail. Where it begins above
// the rail's own recess, as one profile for pads and shelves does, the surface has a ridge along the edge:
//
//   shelf _______   ___ ridge, at the recess where the profile begins
//                | |   \                                                  (disk above)
//                |_|    \____ base
//
// Its width is the distance across the edge over which the profile is shallower than the rail. Such a ridge is often
// narrower than a cell of the film. The air flows over it through a gap that is smaller than on both sides, so that it
// changes the pressure on the whole shelf.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

class Recess;
struct CellGrid;

/// Gaps are compared as at this distance of recess 0 from the disk [m]: not so low that small steps count as edges.
inline constexpr double comparedLift = 60e-9;
/// Such a gap [m]; a recess below 0 does not close it.
inline double comparedGap(double recess) { return std::max(0.1 * comparedLift, recess + comparedLift); }
/// The gaps on both sides of a ridge exceed its own so many times; shelves of 0.1 um have ridges too [-].
inline constexpr double ridgeContrast = 2.0;

/// The edge of a rail from this point to the next one.
struct RailEdge {
    std::size_t rail, point; // indices in the surface
    bool operator==(const RailEdge&) const = default;
};

/// Edges that somewhere along their length have a ridge narrower than the cell there, both measured across the edge.
/// `recess` is that of the surface, which must be valid. A ridge that another rail covers does not count.
std::vector<RailEdge> unresolvedRidges(const AirBearingSurface& surface, const Recess& recess, const CellGrid& grid);

/// The surface with the walls of these edges so many times as wide.
AirBearingSurface withWiderWalls(const AirBearingSurface& surface, std::span<const RailEdge> edges, double times);

} // namespace touchdown
