// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a case to the surface of its disk. A measured file is read once, and again only after it has changed: the last
// one is kept in memory.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/formats/input_problem.h"
#include "core/physics/disk/disk_topography.h"

namespace touchdown {

/// Why the file of a measured surface cannot be used, and what may be wrong with it; empty if the case has none.
struct DiskFileCheck {
    std::vector<InputProblem> problems;
    std::vector<InputProblem> warnings;
    /// Gives both the place that names the file: what concerns the whole file stands there, what concerns one of its
    /// lines ends with it. Line 0: a place without lines, such as an option.
    void nameIn(const std::string& place, int line);
};
DiskFileCheck checkDiskFile(const Case& c);

/// `c` and its file are valid. Generating roughness may take seconds; it stops when `goOn` returns false. Throws
/// std::runtime_error, a sentence, where the file has changed since it was checked and can no longer be read.
DiskTopography diskTopography(const Case& c, const std::function<bool()>& goOn = {});

} // namespace touchdown
