// SPDX-License-Identifier: GPL-3.0-or-later
//
// The wall on one edge of a rail. In the coordinates of the edge, t along it from its first corner and n outwards, the
// wall covers -start n <= t <= length + end n, where `start` and `end` are its spreads: how far it extends beyond the
// corner per unit of n. The border of two walls runs from their corner to the meeting point of the two outer offset
// lines; inside the polygon, to that of the two inner ones.
//
// With d the distance of the own offset line, d' that of the neighbour (0: no wall) and theta the angle by which the
// outline turns at the corner (positive: convex), the offset lines meet at t = length + (d' - d cos theta)/sin theta, n
// = d:
//
//   spread = (d'/d - 1)/sin theta + tan(theta/2)
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/physics/slider/rail_outline.h"

namespace touchdown {

/// A wall profile prepared for evaluation: recess against the signed distance from the edge, linear between the points.
/// Two points at one distance make it vertical; there the farther one counts.
class WallShape {
public:
    explicit WallShape(const WallProfile& profile);

    const std::vector<double>& distances() const { return distance_; } // ascending [m]
    double inner() const { return distance_.front(); }                 // where the wall begins; negative: inside [m]
    double outer() const { return distance_.back(); }                  // where it ends [m]

    /// The recess at a distance from inner() to outer() [m].
    double at(double distance) const;
    /// The smallest recess at this distance and beyond [m].
    double minimumFrom(double distance) const;
    double maximum() const { return maximum_; } // [m]

private:
    std::size_t after(double distance) const; // the index of the first point beyond
    double between(std::size_t next, double distance) const;

    std::vector<double> distance_; // [m]
    std::vector<double> recess_;   // [m]
    std::vector<double> lowest_;   // the smallest recess from this point on [m]
    double maximum_ = 0.0;         // [m]
};

/// The part of a wall outside its polygon (n >= 0), and the one inside it (n <= 0).
enum class WallSide : std::uint8_t { Outside, Inside };

/// [-]
struct WallSpread {
    double outside, inside;
    double operator[](WallSide side) const { return side == WallSide::Outside ? outside : inside; }
};

/// The spread at the corner between the edges with unit vectors `own` and `next`; `turn` is +1 in an anticlockwise
/// outline, else -1; `neighbour` is null for an edge without a wall. At the first corner of an edge, mirrored: -1 times
/// both, and the own edge first.
WallSpread wallSpread(const SurfacePoint& own, const SurfacePoint& next, double turn, const WallShape& shape,
                      const WallShape* neighbour);

class RailWall {
public:
    /// From corner `a` to corner `b`; `turn` as above. Keeps a reference to the shape.
    RailWall(const RailPoint& a, const RailPoint& b, double turn, const WallShape& shape, WallSpread start,
             WallSpread end, int rail);

    int rail() const { return rail_; }
    SurfacePoint firstCorner() const { return {x_, y_}; } // of its edge [m]
    SurfacePoint outwards() const { return {nx_, ny_}; }  // normal to its edge [-]
    /// The corners of that part of the wall, without the arcs about its ends; a triangle where its borders meet. Empty
    /// where it has none.
    std::vector<SurfacePoint> corners(WallSide side) const;
    const WallShape& shape() const { return *shape_; }
    double length() const { return length_; } // of its edge [m]
    /// A point of the offset line at a distance outwards, from 0 at the border with the wall before to 1 at that with
    /// the wall behind; `inset` [m] away from both. Where the borders have met it lies beyond them.
    SurfacePoint onOffsetLine(double distance, double share, double inset) const;
    bool has(WallSide side) const { return side == WallSide::Outside ? shape_->outer() > 0.0 : shape_->inner() < 0.0; }

    /// The recess of the wall at a point outside its polygon; infinity where it has none [m].
    double recessOutside(double x, double y) const;
    /// The recess of the wall at a point inside its polygon.
    std::optional<double> recessInside(double x, double y) const;

    /// A box that holds all of the wall.
    SurfaceBox bounds() const;
    /// False if no point of the box is in that part of the wall; may be true for a box just beside it.
    bool meets(const SurfaceBox& box, WallSide side) const;
    /// A lower bound of the recess of the outside part in the box [m].
    double lowestOutside(const SurfaceBox& box) const;

    /// Appends where the line crosses the borders of that part and the offset lines and arcs of the points of its
    /// profile, without the edge itself, which belongs to the outline.
    void breaks(const ScanLine& line, WallSide side, std::vector<double>& out) const;

private:
    struct Place {
        double t, n; // [m]
    };
    Place place(double x, double y) const;
    double distance(Place p) const;
    double end(WallSide side) const { return side == WallSide::Outside ? shape_->outer() : shape_->inner(); }
    bool covers(Place p, WallSide side, double margin) const;

    struct Crossing;
    void offsetLine(const Crossing& crossing, double distance) const;
    void arc(const Crossing& crossing, double distance, bool atEnd) const;
    void border(const Crossing& crossing, bool atEnd) const;
    void keep(const Crossing& crossing, double along) const;

    double x_, y_;   // the first corner [m]
    double ux_, uy_; // along the edge
    double nx_, ny_; // outwards
    double length_;  // [m]
    WallSpread start_, end_;
    const WallShape* shape_;
    int rail_;
};

/// The walls of a rail, one for each edge that has one; `index` is its number in the surface. None of a ramp, nor of a
/// step at or below the base recess. The walls refer to the shapes.
std::vector<RailWall> railWalls(const Rail& rail, int index, double baseRecess, const std::vector<WallShape>& shapes);

} // namespace touchdown
