// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far an elastic contact on a grid of cells is from the limit of infinitely small ones.
//
// The state is solved once more on finer cells: on a window around all places where the undeformed surfaces overlap,
// which is exact, as no pressure acts elsewhere; over the whole patch where it is periodic. With F on the cells of the
// state and f on cells r times as fine, the error of F is at most |F - f| and the error of f together. The latter is
// the larger of two bounds:
//
//   |F - f|/(r - 1)         where the error shrinks in proportion to the cell, as at the edges of a flat pad,
//   sum of 0.4 f_i/n_i      over the islands i of contact with n_i cells: the error of a sphere's force is within 0.38
//                           of it per cell in contact (within 0.12 (cell/contact radius)^2, found on drawn spheres
//                           with contact radii from 1 to 25 cells, against Hertz), and falls as 1/n.
//
// r is 2, or larger, to 64, where few cells or none touch, so that also a contact smaller than a cell is found. A state
// of many cells is compared with one of cells twice as large instead, whose difference is at least the error where it
// shrinks in proportion to the cell or faster. The area's error is measured in the same way, with half the cells at the
// rims of the islands as bound. Features smaller than the finer cells are not seen.
#pragma once

#include <functional>
#include <span>

#include "core/physics/contact/half_space.h"

namespace touchdown {

/// Sets the separation [m] of the undeformed surfaces at the centres of any grid, also beyond the patch: there it is
/// large where the pad ends.
using SeparationOn = std::function<void(const UniformGrid& grid, std::span<double> separation)>;

/// A state of contact to be judged.
struct ContactState {
    UniformGrid grid;
    double modulus = 0.0; // E* [Pa]
    HalfSpaceEdges edges = HalfSpaceEdges::Free;
    double hardness = 0.0;            // H [Pa]; 0: none
    std::span<const double> pressure; // of contact, one for each cell [Pa]
};

struct ContactGridError {
    bool known = false;  // the other grid was solved
    double force = 0.0;  // error of the contact force [N]
    double area = 0.0;   // of the area of contact [m^2]
    double cell = 0.0;   // side of the cells that the state was compared with [m]
    double other = 0.0;  // contact force with these [N]
    long long cells = 0; // in contact on the state's own grid
};

/// The error of a state without adhesion. If `goOn` returns false the solution ends, and the error is not known.
ContactGridError contactGridError(const ContactState& state, const SeparationOn& separation,
                                  const std::function<bool()>& goOn = {});

/// The same rectangle in half as many cells along and across, one more where that is no whole number.
UniformGrid coarsened(const UniformGrid& grid);

/// Of the difference from cells twice as large: the error of a contact with adhesion shrinks as cell^0.74 or faster.
inline constexpr double moreThanCoarse = 1.5;

/// Whether contact at the border of the patch continues beyond it: next to a touching cell at the border the undeformed
/// surfaces overlap outside. That part is missing in the state.
bool isCutOff(const ContactState& state, const SeparationOn& separation);

} // namespace touchdown
