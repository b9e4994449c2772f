// SPDX-License-Identifier: GPL-3.0-or-later
//
// The outline of a slider above the disk as it is seen from the side or from the rear: at each place the smallest gap
// of all that lie behind each other.
#pragma once

#include <vector>

#include "core/case/case.h"
#include "core/physics/slider/attitude.h"

namespace touchdown {

class SliderProfile {
public:
    static constexpr int along = 400;  // steps from the leading to the trailing edge
    static constexpr int across = 120; // steps from the inner to the outer edge

    SliderProfile() = default;
    /// Of a film case with a valid surface.
    explicit SliderProfile(const Case& c);

    bool empty() const { return recess_.empty(); }
    double length() const { return length_; } // [m]
    double width() const { return width_; }   // [m]

    /// `along` + 1 heights above the mean plane of the disk, from the leading to the trailing edge [m].
    std::vector<double> fromSide(const Attitude& attitude) const;
    /// `across` + 1 heights, from the inner to the outer edge [m].
    std::vector<double> fromRear(const Attitude& attitude) const;

private:
    double gap(int i, int j, const Attitude& attitude) const;

    double length_ = 0.0, width_ = 0.0;
    std::vector<double> recess_; // at (along + 1) x (across + 1) points, x fastest [m]
};

} // namespace touchdown
