// SPDX-License-Identifier: GPL-3.0-or-later
//
// The multi-asperity model (core/physics/contact/multi_asperity.h) along one way in and out, as a table.
#pragma once

#include <vector>

#include "core/physics/contact/multi_asperity.h"

namespace touchdown {

/// One point of the curve of a pad that goes in and out.
struct MultiAsperityPoint {
    double padSeparation = 0.0; // d [m]
    MultiAsperityState state;
    MultiAsperityForces forces;
};

/// In from `start` to `closest` and back out, `points` evenly spaced ones each way; a jump adds its two ends at one d.
struct MultiAsperityCurve {
    std::vector<MultiAsperityPoint> towards, away;
    std::vector<MultiAsperityJump> touchDowns, takeOffs;
    /// What the pad's drive lost on the way in and out: the area of the loop F_c(d) [J].
    double work = 0.0;
};

MultiAsperityCurve multiAsperityCurve(const MultiAsperity& model, double start, double closest, int points = 401);

} // namespace touchdown
