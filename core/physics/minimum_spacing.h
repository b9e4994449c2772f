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

private:
    struct Candidate {
        double x, y, recess; // [m]
    };
    double length_, width_; // [m]
    std::vector<Candidate> candidates_;
};

} // namespace touchdown
