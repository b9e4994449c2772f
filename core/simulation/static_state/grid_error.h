// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a static state on one grid is from the limit of infinitely many cells, from the states on coarser grids, from
// what the cells carry that edges and walls cross, or that take parts of such faces (cut_rows.h), and from ridges that
// are narrower than a cell (ridge_error.h).
//
// At second order the difference from a grid of half as many cells along each axis is three times the finer one's
// error; half of it is taken because of the rails' edges, and all of it in flight where ridges are narrower than a
// cell, which leave an error of first order. As two results may agree by chance, an eighth of the difference of the two
// coarser ones counts too: as much at second order. And in cells that edges cross the error is of first order in their
// size and of either sign: a share of what they carry counts, which moves the attitude against the film's stiffness;
// more where narrow ridges stand, as what leaks through them moves the pressure of whole rails. Share and factors were
// chosen on sliders drawn at random that fly near 14 nm; tests/bench/README.md says on how many others they hold. Below
// some 2 nm, where the pressure at the trailing edge rises within a cell, the error may be several times as large.
#pragma once

#include <optional>
#include <span>

#include "core/numerics/small_matrix.h"
#include "core/physics/slider/air_bearing_surface.h"
#include "core/physics/slider/attitude.h"

namespace touchdown {

struct Case;
struct DiscretisationError;
struct FilmLevel;

/// A static state on one grid.
struct GridState {
    Attitude attitude;
    SurfacePoint nearest;  // to the disk [m]
    double minimumSpacing; // [m]
    double load, positive; // net force of the film, and that of the pressure above ambient [N]
};

/// `level` solved, with the state `finest`; `coarser`: the next coarser grid first, not empty. Without stiffness the
/// shares of crossed cells and ridges count for the load alone. `ridges`: the uncertain force and torques of each edge
/// whose ridge is narrower than a cell [N], [N m].
DiscretisationError gridError(const Case& c, const FilmLevel& level, const std::optional<Matrix3>& stiffness,
                              const GridState& finest, std::span<const GridState> coarser,
                              std::span<const Vector3> ridges = {});

} // namespace touchdown
