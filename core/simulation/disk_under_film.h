// SPDX-License-Identifier: GPL-3.0-or-later
//
// The disk's surface as the film's cells see it: its mean over each cell, moved along with the disk or held still. What is shorter than
// a cell does not act on the film. The whole surface moves as it does under the slider's centre.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/numerics/padded_grid.h"
#include "core/physics/disk_topography.h"
#include "core/physics/disk_velocity.h"
#include "core/simulation/case.h"

namespace touchdown {

/// Velocity of the surface under the slider's centre [m/s]; zero where it is flat or held still.
Velocity surfaceVelocity(const Case& c, const DiskTopography& surface);

class DiskUnderFilm {
public:
    /// Surface, grid and pad must last.
    DiskUnderFilm(const Case& c, const DiskTopography& surface, const CellGrid& grid, const PaddedGrid& pad);

    /// Nothing to add anywhere at any time.
    bool flat() const { return surface_.flat(); }
    bool moves() const { return velocity_.x != 0.0 || velocity_.y != 0.0; }
    /// Velocity of the surface under the slider's centre [m/s].
    Velocity velocity() const { return velocity_; }
    /// Mean heights at a time [s]; padded [m], the rings as the nearest cell. Allocates nothing.
    void at(double time, std::span<double> height);

private:
    const DiskTopography& surface_;
    const CellGrid& grid_;
    const PaddedGrid& pad_;
    Velocity velocity_;
    std::vector<double> means_; // row by row [m], at meansTime_
    double meansTime_ = std::numeric_limits<double>::quiet_NaN();
};

} // namespace touchdown
