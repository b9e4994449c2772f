// SPDX-License-Identifier: GPL-3.0-or-later
//
// The air bearing surface (ABS) as it is designed: rails with a recess or a ramp, wall profiles on their edges, base
// recess, form and taper. x runs from the leading to the trailing edge, y from the inner to the outer edge; a recess is
// positive away from the disk, from the zero plane.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace touchdown {

struct SurfacePoint {
    double x = 0.0; // from the leading edge [m]
    double y = 0.0; // from the inner edge [m]
    bool operator==(const SurfacePoint&) const = default;
};

/// A corner of a rail, and what stands on the edge from here to the next corner (the last closes to the first).
struct RailPoint {
    double x = 0.0; // from the leading edge [m]
    double y = 0.0; // from the inner edge [m]
    int wall = 0;   // 0: a vertical edge; n: the profile walls[n - 1]
    bool operator==(const RailPoint&) const = default;
};

enum class RailKind : std::uint8_t { Step, Ramp };

/// A polygon, clockwise or not. A step has one recess; a ramp is the plane through the recesses at its first three
/// points.
struct Rail {
    RailKind kind = RailKind::Step;
    std::vector<RailPoint> points;  // three or more
    std::array<double, 3> recess{}; // [m]; a step uses the first, which may be negative
    bool operator==(const Rail&) const = default;
};

/// Recess against the distance normal to an edge (negative: inside the polygon), linear between the points.
struct WallProfile {
    std::vector<double> distance; // [m], ascending
    std::vector<double> recess;   // from the zero plane, not from the rail [m]; as many as distances
    bool operator==(const WallProfile&) const = default;
};

/// A corner of a rail, or an edge: both its corners.
struct RailPlace {
    std::size_t rail = 0;
    std::size_t corner = 0; // of an edge its first
    bool edge = false;
    bool operator==(const RailPlace&) const = default;
};

/// A distance that edits keep: `to` minus `from`, along x or y. An edge is at one place along that axis.
struct KeptDistance {
    RailPlace from, to;
    bool alongX = true;
    double value = 0.0; // [m]
    bool operator==(const KeptDistance&) const = default;
};

/// Two rails whose outlines stay mirror images about the centre line; a rail with itself is symmetric.
struct KeptSymmetry {
    std::size_t rail = 0, image = 0;
    bool operator==(const KeptSymmetry&) const = default;
};

struct AirBearingSurface {
    std::vector<Rail> rails; // where tops overlap, the last rail counts
    std::vector<WallProfile> walls;
    double baseRecess = 2e-6;                   // where no rail is [m]
    double crown = 0.0;                         // [m], along the length
    double camber = 0.0;                        // [m], across the width
    double twist = 0.0;                         // [m]
    double taperLength = 0.0;                   // [m]
    double taperAngle = 0.0;                    // [rad]
    std::vector<SurfacePoint> pointsOfInterest; // where the spacing is reported
    std::vector<KeptDistance> distances;        // for edits alone (core/physics/slider/surface_relations.h)
    std::vector<KeptSymmetry> symmetries;       // likewise
    bool operator==(const AirBearingSurface&) const = default;
};

} // namespace touchdown
