// SPDX-License-Identifier: GPL-3.0-or-later
//
// A wall profile prepared for evaluation: recess against the signed distance from the edge, linear between the points.
// Two points at one distance make it vertical; there the farther one counts.
#pragma once

#include <cstddef>
#include <vector>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

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

} // namespace touchdown
