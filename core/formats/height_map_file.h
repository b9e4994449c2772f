// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measured surfaces from files: profiles along the track and maps. The file name extension selects the format.
//
//   *.h5, *.hdf5   datasets x (nx), y (ny) and height (ny rows of nx) in the root; for a profile x (nx), height (nx).
//                  An attribute "unit" of each is a length; without it the unit is m.
//   *.def          wave.def of the established program: lines "x h1 ... hny", x in m, h in nm; the last line holds
//                  the y of the ny profiles in m.
//   others         text, numbers separated by blanks, tabs, commas or semicolons:
//                    two columns     x, height: a profile
//                    three columns   x, y, height: a map, every point once, line by line along x or along y
//                    a matrix        of heights, the first line at y = 0, after comments with its size and unit:
//                                    "# Width: 10 um", "# Height: 5 um", "# Value units: nm" (as Gwyddion writes)
//                  Lines that begin with #, %, ! or // are comments; headings may precede the first number.
//                  Lengths are in m, or in the units in brackets in a heading or comment, one per column:
//                  "x [um]  h [nm]".
//
// x and y ascend in equal steps; the first point lies at x = y = 0 of the disk. A map has no holes: every number is
// finite and every line complete. A last row or column that repeats the first one closes the map (see
// core/physics/disk/height_map.h).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/input_problem.h"
#include "core/physics/disk/height_map.h"

namespace touchdown {

struct HeightMapDocument {
    HeightMap map;                      // valid if there are no problems
    std::vector<InputProblem> problems; // with file, line and what is allowed
    bool valid() const { return problems.empty(); }
};

/// Reads a file of any format. `name` is its name in the problems.
HeightMapDocument readHeightMap(const std::filesystem::path& file, const std::string& name);

/// The text formats; the extension of `name` selects one.
HeightMapDocument readHeightMapText(std::string_view text, const std::string& name);

} // namespace touchdown
