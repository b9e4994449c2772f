// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the established program's files have no place for, kept in the comments of a run.dat, which that program does
// not read:
//
//   touchdown: film.scheme = { was = "power-law", is = "limited" }
//
// `was` is what the files say without the comment, so that a value that somebody has changed in the files since is not
// undone.
#pragma once

#include <string>
#include <vector>

#include "core/case_files/cml/cml_fields.h"

namespace touchdown {

struct CmlKeptValues {
    std::string comments;          // lines of a run.dat
    std::vector<std::string> keys; // that the model of the case uses, but for its title and what it says of itself
};

/// What is needed to make `wanted` of `read`.
CmlKeptValues keepValues(const Case& wanted, const Case& read);

/// Puts the values that the comments of a file keep into the case, and takes their lines out of the comments.
void applyKeptValues(CmlFields& fields);

} // namespace touchdown
