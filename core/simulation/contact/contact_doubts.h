// SPDX-License-Identifier: GPL-3.0-or-later
//
// Errors of an elastic contact that come from its grid and its patch: the error of the grid, contact that the
// border of the patch cuts off, and attraction beyond it. Each becomes a figure or a warning.
//
// Where a warning names a cause that other cells do not show, the error of each figure that depends on it is not known:
//
//   the border cuts the contact off        every figure
//   a surface with features below a cell   every figure
//   edges of the contact hang on cells     every figure of a contact with adhesion
//   attraction beyond the border           every figure but the pull-off force, whose error contains that attraction
//   the way out ends in contact            the pull-off and the work of the loop
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/physics/contact/contact_grid_error.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

struct Case;

/// The errors of all patches of one state together.
struct ContactDoubts {
    std::optional<ContactGridError> grid; // not of a contact with adhesion, whose state depends on its history
    bool cutOff = false;
    bool belowCell = false;      // a measured surface has features below a cell
    double adhesionBeyond = 0.0; // at most, around a sphere's patch [N]

    void add(const ContactGridError& patch);
};

/// Length of the zone at the edge of a contact over which adhesion lets go (Maugis 1992) [m]; infinite without
/// adhesion.
double adhesionZone(const Case& c);
/// Fewer than two cells lie in that zone: the edges of the contact hang on cells and jump from one to the next.
bool edgesHangOnCells(const Case& c);
/// Whether the difference from other cells covers the error of the contact force and area.
bool coversError(const Case& c, const ContactDoubts& doubts);

/// Warnings about a state with the contact force `force` and the adhesion force `adhesion` <= 0 [N].
std::vector<std::string> warningsOf(const Case& c, const ContactDoubts& doubts, double force, double adhesion);

/// The case for such a comparison: without fields and with at most 200 samples. Over a surface that moves the samples
/// stay, because forces depend on when they are looked at.
Case withFewerSamples(const Case& c);

/// A run with adhesion, against which its errors are found.
struct ContactComparison {
    const Summary& other; // the same with cells twice as large
    double adhesion;      // at the closest approach, to which the doubts belong [N]
    double resolution;    // of the separations of jumps [m]
    bool parts;           // the surfaces do not touch at the end of the way out
};

/// Adds "<figure>_error" behind each figure that depends on the grid, NaN where it is not known: 1.5 of the difference
/// from `other`, `resolution` of the separations, and of the pull-off force `adhesionBeyond`. Warns of large ones, and
/// of figures that `other` does not have. On 16 drawn spheres with two to three cells in the zone where adhesion lets
/// go, against cells of a third: the pull-off force's error was covered in all, and 5 times smaller or more; that of
/// snap-in in 16 of 16, of release in 14 of 14. Both runs may agree by chance: the error of the pull-off separation was
/// covered in 13 of 16 only (worst: a fifth of the true one was stated), of the largest contact force in 10 of 16
/// (worst: a quarter).
void addErrors(const Case& c, const ContactDoubts& doubts, Summary& summary, const ContactComparison& comparison);

/// The same without a comparison: none is known.
void addUnknownErrors(Summary& summary);

/// Without adhesion: adds the errors of the largest contact force, and of the area, known where it is that of the same
/// state.
void addErrors(const Case& c, const ContactDoubts& doubts, Summary& summary, bool sameState);

} // namespace touchdown
