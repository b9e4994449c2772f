// SPDX-License-Identifier: GPL-3.0-or-later
//
// The disk's surface as the film's cells see it: its mean over each cell, moved along with the disk or held still. What
// is shorter than a cell does not act on the film. The whole surface moves as it does under the slider's centre.
//
// It acts in all cells, also where the gap is large: there are many of them. Fig. 2, case II (RMS 0.2 nm), moves
// otherwise by 5e-14 m within 12 us if the half of the cells is left out that has a gap above 2 um, by 7e-12 m without
// those above 0.2 um: the run's error of a step is 1e-11 m. What waves of the slider's length do to the air in a deep
// cavity is more.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/case/case.h"
#include "core/numerics/cell_grid.h"
#include "core/numerics/padded_grid.h"
#include "core/physics/disk/disk_topography.h"
#include "core/physics/disk/disk_velocity.h"

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
    /// Mean heights at a time [s]; padded [m], the rings as the nearest cell. Allocates nothing after the first time.
    void at(double time, std::span<double> height);

private:
    const DiskTopography& surface_;
    const CellGrid& grid_;
    const PaddedGrid& pad_;
    Velocity velocity_;
    std::vector<double> means_; // row by row [m], at meansTime_
    std::vector<double> work_;
    double meansTime_ = std::numeric_limits<double>::quiet_NaN();
};

} // namespace touchdown
