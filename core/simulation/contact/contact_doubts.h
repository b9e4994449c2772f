// SPDX-License-Identifier: GPL-3.0-or-later
//
// Errors of an elastic contact that come from its grid and its patch: the error of the grid, contact that the
// border of the patch cuts off, and attraction beyond it. Each becomes a figure or a warning.
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
    double adhesionBeyond = 0.0; // at most, around a sphere's patch [N]

    void add(const ContactGridError& patch);
};

/// Warnings about a state with the contact force `force` and the adhesion force `adhesion` <= 0 [N].
std::vector<std::string> warningsOf(const Case& c, const ContactDoubts& doubts, double force, double adhesion);

/// The case for such a comparison: without fields and with at most 200 samples. Over a surface that moves the samples
/// stay, because forces depend on when they are looked at.
Case withFewerSamples(const Case& c);

/// Adds "<figure>_error" behind each figure that depends on the grid, from `other`, the same run with cells twice as
/// large: 1.5 of the difference, `resolution` of the separations [m], and of the pull-off force `adhesionBeyond`. Warns
/// of large ones, and of figures that `other` does not have. On 16 drawn spheres with two to three cells in the zone
/// where adhesion lets go, against cells of a third: the pull-off force's error was covered in all, and 5 times smaller
/// or more; that of snap-in in 16 of 16, of release in 14 of 14. Both runs may agree by chance: the error of the
/// pull-off separation was covered in 13 of 16 only (worst: a fifth of the true one was stated), of the largest contact
/// force in 10 of 16 (worst: a quarter). With fewer cells in that zone edges hang on cells, and no error is covered for
/// sure.
void addErrors(const Case& c, Summary& summary, const Summary& other, double adhesionBeyond, double resolution);

/// Adds the error of the largest contact force, and of the area where it is that of the same state.
void addErrors(Summary& summary, const ContactGridError& error, bool withArea);

} // namespace touchdown
