// SPDX-License-Identifier: GPL-3.0-or-later
//
// The recess s(x, y) of an air bearing surface: its height above the zero plane, positive away from the disk, with
// walls, form and taper.
//
//   top    of the rail that comes last in the list; the base recess where there is no rail. An outline belongs to its
//          rail: a point on it is inside (exact on edges parallel to an axis, to rounding on others).
//   wall   profile of the distance normal to its edge. Outside its own polygon a wall holds wherever it is shallower
//          than the surface there, whatever the order of the rails. Ramps, and steps at or below the base recess,
//          have no walls. At a corner of two walled edges each wall ends at the line from the corner to the meeting
//          point of the two outer offset lines; beyond the end of an edge the distance to the corner counts. Next to
//          an edge without a wall a wall ends on that edge's straight extension. Inside its own polygon (negative
//          distances) a wall replaces the rail's top, where that is visible. There walls end towards the meeting
//          point of the two inner offset lines, and the deepest of several holds.
//   taper  for x < length the recess is at least angle (length - x)
//   form   s - 4 crown X (1 - X) - 4 camber Y (1 - Y) - 4 twist (X - 1/2)(Y - 1/2), X = x/L, Y = y/W
#pragma once

#include <memory>
#include <vector>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

/// The recess of one surface, prepared for many evaluations. Copies share the prepared data; reading is thread-safe.
class Recess {
public:
    /// `length`, `width` of the slider [m], positive. The surface must be valid (finite numbers, walls that exist).
    Recess(const AirBearingSurface& surface, double length, double width);

    double length() const; // [m]
    double width() const;  // [m]

    /// The recess at a point of the slider, or at the nearest point of its outline [m].
    double at(double x, double y) const;

    /// Appends, ascending, the x in (x0, x1) where the recess along the line y = const may jump or kink: edges of tops,
    /// ends and corners of wall profiles, the end of the taper. Exact to round-off for jumps.
    void breaksAlongX(double y, double x0, double x1, std::vector<double>& out) const;
    /// The same for the line x = const, y in (y0, y1).
    void breaksAlongY(double x, double y0, double y1, std::vector<double>& out) const;

    /// Whether no edge, wall or end of taper meets the box; may also be false just beside one.
    bool isSmooth(double x0, double x1, double y0, double y1) const;

    struct Slopes {
        double x, y; // [-]
    };
    /// Those of the recess where neither edge, wall nor ramp is, behind the taper.
    Slopes formSlopes(double x, double y) const;
    double taperLength() const; // [m]

private:
    struct Prepared;
    std::shared_ptr<const Prepared> prepared_;
};

} // namespace touchdown
