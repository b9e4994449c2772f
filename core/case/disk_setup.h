// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a case to the surface of its disk.
#pragma once

#include <functional>
#include <vector>

#include "core/case/case.h"
#include "core/formats/input_problem.h"
#include "core/physics/disk/disk_topography.h"

namespace touchdown {

/// Why the file of a measured surface cannot be used; empty if it can, or if the case has none.
std::vector<InputProblem> diskFileProblems(const Case& c);

/// `c` and its file are valid. Generating roughness may take seconds; it stops when `goOn` returns false.
DiskTopography diskTopography(const Case& c, const std::function<bool()>& goOn = {});

} // namespace touchdown
