// SPDX-License-Identifier: GPL-3.0-or-later
//
// Grids for a slider's film: lines on the long edges of its rails, denser where edges are many or where a known
// pressure bends.
#pragma once

#include <span>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

CellGrid uniformGrid(double length, double width, int nx, int ny);

/// From the rails alone.
CellGrid gradedGrid(const AirBearingSurface& surface, double length, double width, int nx, int ny);

/// What is known of a film from another grid.
struct KnownFilm {
    CellGrid grid;
    std::vector<double> pressure; // row by row [Pa]
    std::vector<double> gap;      // mean of each cell [m]
    double ambient = 0.0;         // on the outline [Pa]
    double draggedGap = 0.0;      // below it the disk drags more air along than flows by pressure [m]
};
/// The gap at which convection and diffusion are alike over a hundredth of the length, sqrt(6 mu U L/(100 p0)) [m].
double draggedGap(double viscosity, double speed, double length, double ambient);

/// From the long edges, and denser where the known pressure bends or a small gap changes, so that what each cell leaves
/// out of the load is alike.
CellGrid adaptedGrid(const AirBearingSurface& surface, double length, double width, int nx, int ny,
                     const KnownFilm& known);

/// A field on the cells of one grid, taken at the cell centres of another, bilinearly; `outline` is its value there.
std::vector<double> transfer(const CellGrid& from, std::span<const double> field, double outline, const CellGrid& to);

} // namespace touchdown
