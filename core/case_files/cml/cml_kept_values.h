// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values that the established program's files cannot hold. They are kept in the comments of a run.dat, which that
// program does not read:
//
//   touchdown: film.scheme = { was = "power-law", is = "limited" }
//
// `was` is the value of the files without the comment, so that a value that was changed in the files later is not
// overwritten.
#pragma once

#include <string>
#include <vector>

#include "core/case_files/cml/cml_parameters.h"

namespace touchdown {

struct CmlKeptValues {
    std::string comments;          // lines of a run.dat
    std::vector<std::string> keys; // that the model of the case uses, except title and [about]
};

/// The values and comments that turn `read` into `wanted`.
CmlKeptValues keepValues(const Case& wanted, const Case& read);

/// Puts the values kept in the comments of a file into the case, and removes their lines from the comments.
void applyKeptValues(CmlParameters& parameters);

} // namespace touchdown
