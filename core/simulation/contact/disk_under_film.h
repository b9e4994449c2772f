// SPDX-License-Identifier: GPL-3.0-or-later
//
// The disk's surface under the film's cells: its mean over each cell, moved with the disk or held still. Waves shorter
// than a cell do not act on the film. The whole surface moves as it does under the slider's centre.
//
// It acts in all cells, also where the gap is large, since these are many. Fig. 2, case II (RMS 0.2 nm): without the
// half of the cells with a gap above 2 um the motion changes by 5e-14 m within 12 us, without those above 0.2 um by
// 7e-12 m; the run's error of a step is 1e-11 m. Waves of the slider's length have a larger effect in deep cavities.
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
