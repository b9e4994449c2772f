// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a surface comes nearest to the mean plane of the disk. Independent of the film's grid: rails come nearest at their
// corners and edges, or, with crown and camber, inside.
#pragma once

#include <vector>

#include "core/physics/attitude.h"
#include "core/physics/recess.h"

namespace touchdown {

class MinimumSpacing {
public:
    MinimumSpacing(const AirBearingSurface& surface, const Recess& recess);

    struct Place {
        double spacing; // [m], may be negative
        SurfacePoint at; // [m]
    };
    Place at(const Attitude& attitude) const;
    /// The minimum spacing at the mean place of all that comes within `depth` [m], > 0, of it, weighted from 1 at the nearest to 0
    /// there: unlike the nearest point itself it moves continuously with the attitude. A symmetric pad's is in its middle.
    Place bearing(const Attitude& attitude, double depth) const;

private:
    struct Candidate {
        double x, y, recess; // [m]
    };
    double above(const Candidate& c, const Attitude& attitude) const
    {
        return c.recess + attitude.height + attitude.pitch * (length_ - c.x) - attitude.roll * (c.y - 0.5 * width_);
    }
    double length_, width_; // [m]
    std::vector<Candidate> candidates_;
};

} // namespace touchdown
