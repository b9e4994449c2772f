// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a surface comes nearest to the mean plane of the disk. Independent of the film's grid: rails come nearest at
// their corners and edges, or, with crown and camber, inside.
//
// The many thousand points that are looked at stand in blocks. None of a block's comes lower than its least recess
// would at that corner of its box which the attitude presses down, also by rounding, for the same sum of smaller parts
// is never larger: most blocks are passed over, and the result is that of all points.
#pragma once

#include <vector>

#include "core/physics/slider/attitude.h"
#include "core/physics/slider/recess.h"

namespace touchdown {

class MinimumSpacing {
public:
    MinimumSpacing(const AirBearingSurface& surface, const Recess& recess);

    struct Place {
        double spacing;  // [m], may be negative
        SurfacePoint at; // [m]
    };
    Place at(const Attitude& attitude) const;
    /// The minimum spacing at the mean place of all that comes within `depth` [m], > 0, of it, weighted from 1 at the
    /// nearest to 0 there: unlike the nearest point itself it moves continuously with the attitude. A symmetric pad's
    /// is in its middle.
    Place bearing(const Attitude& attitude, double depth) const;

private:
    struct Candidate {
        double x, y, recess; // [m]
    };
    /// So many neighbours in the list, or the rest of it: least and greatest x and y, least recess.
    static constexpr std::size_t blockSize = 16;
    struct Block {
        double x0, x1, y0, y1, recess; // [m]
    };
    void setBlocks();
    double above(const Candidate& c, const Attitude& attitude) const
    {
        return c.recess + attitude.height + attitude.pitch * (length_ - c.x) - attitude.roll * (c.y - 0.5 * width_);
    }
    /// No point of a block is lower.
    double bound(const Block& b, const Attitude& attitude) const
    {
        return above({attitude.pitch > 0.0 ? b.x1 : b.x0, attitude.roll > 0.0 ? b.y1 : b.y0, b.recess}, attitude);
    }
    double length_, width_; // [m]
    std::vector<Candidate> candidates_;
    std::vector<Block> blocks_;
};

} // namespace touchdown
