// SPDX-License-Identifier: GPL-3.0-or-later
//
// The disk's surface as the film's cells see it: its mean over each cell, moved along with the disk or held still. What is shorter than
// a cell does not act on the film.
#pragma once

#include <span>

#include "core/numerics/cell_grid.h"
#include "core/numerics/padded_grid.h"
#include "core/physics/disk_topography.h"
#include "core/simulation/case.h"

namespace touchdown {

class DiskUnderFilm {
public:
    /// Surface, grid and pad must last.
    DiskUnderFilm(const Case& c, const DiskTopography& surface, const CellGrid& grid, const PaddedGrid& pad);

    /// Nothing to add anywhere at any time.
    bool flat() const { return surface_.flat(); }
    bool moves() const { return velocity_.x != 0.0 || velocity_.y != 0.0; }
    /// Velocity of the surface under the slider's centre [m/s].
    Velocity velocity() const { return velocity_; }
    /// Mean heights at a time [s]; padded [m]. Allocates nothing.
    void at(double time, std::span<double> height);

private:
    const DiskTopography& surface_;
    const CellGrid& grid_;
    const PaddedGrid& pad_;
    Velocity velocity_;
    std::vector<double> row_;
};

} // namespace touchdown
