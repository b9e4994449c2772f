// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much of a surface is lost on a grid of cells that samples it at their centres. Measured on up to 512 x 256 cells
// of the same size and place, but not more than one period of the surface.
#pragma once

#include "core/numerics/cell_grid.h"
#include "core/physics/disk/disk_topography.h"

namespace touchdown {

struct SurfaceSampling {
    double rms = 0.0;        // of the heights at the centres of the cells, about their mean [m]
    double rmsOfMap = 0.0;   // of the heights at the points of the surface's finest map, in the same place [m]
    double unresolved = 0.0; // RMS distance of the surface from the mean of four cells, in the middle of them [m]: a
                             // wave of 8 cells along one axis shows 8 % of its own RMS there, of 4 cells 29 %, of 2
                             // cells all of it
};
SurfaceSampling surfaceSampling(const DiskTopography& surface, const UniformGrid& grid);

/// The largest step of the surface where a grid is repeated beside itself, along x or y [m]; rounding where the
/// surface repeats with it.
double largestSeam(const DiskTopography& surface, const UniformGrid& grid);

} // namespace touchdown
