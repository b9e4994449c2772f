// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measured surfaces from files: profiles along the track and maps. The file name extension selects the format.
//
//   *.h5, *.hdf5   datasets x (nx), y (ny) and height (ny rows of nx) in the root; for a profile x (nx), height (nx).
//                  Attributes of each: "unit" or "units", a length; "scale_factor" and "add_offset" as in netCDF: the
//                  value is number * scale_factor + add_offset; "_FillValue", "missing_value": the number of a hole.
//   *.def          wave.def of the established program: lines "x h1 ... hny", x in m, h in nm; the last line holds
//                  the y of the ny profiles in m.
//   *.gsf          Gwyddion Simple Field, and SDF as text: core/formats/surfaces/surface_fields.h.
//   others         text in UTF-8, Latin-1 or, with its mark, UTF-16:
//                    one column      heights, after a line with their distance, "# Spacing: 0.5 um"
//                    two columns     x, height: a profile, x ascending or descending
//                    three columns   x, y, height: a map, every point once, in any order
//                    a matrix        of heights, the first line at y = 0, after lines with its size and unit, as
//                                    Gwyddion, SPIP, WSxM, Keyence and ESRI write them: "# Width: 10 um",
//                                    "# Height: 5 um", "# Value units: nm" (core/formats/surfaces/header_values.h)
//                  Lines that begin with #, %, ! or // are comments; headings may precede the first number. Columns and
//                  decimal commas: core/formats/surfaces/map_table.h.
//
// Lengths have units. A heading names one for each column, "x [um]  h [nm]", "x in um, h in nm", "x_um,h_nm", "um;nm"
// (core/formats/surfaces/heading_cells.h), or two lines do, "lateral_unit: um" and "height_unit: nm", or the case gives
// them as disk.surface.unit; where several do, they are the same. A sentence gives no unit to a column. Without units a
// file is refused, and so is a heading with fewer units than columns or with a unit that is no length.
//
// A column or channel whose name says that it is no height ("gap", "log10 z", "z^2", "std of z", "counts") is refused.
// Heights that count downwards ("depth", "-z", "inverted") are turned, with a warning
// (core/formats/surfaces/column_name.h). A name that is not known is refused, or read as a height with a warning where
// the case gives the units. A remark on direction, factor, unit or number of points that was not used is quoted in a
// warning (core/formats/surfaces/surface_remarks.h). A surface with an rms slope above 1 is refused; one with a slope
// above 0.1 is warned of (core/physics/disk/disk_surface_check.h).
//
// The steps of x and y are equal; the lowest x and y lie at x = y = 0 of the disk. A surface has no holes: every number
// is finite, every line complete, and no height is a mark of a missing point (core/formats/surfaces/map_holes.h). A
// file holds one profile or one channel. An index column is left out where its heading names it
// (core/formats/surfaces/surface_heading.h). A last row or column that repeats the first one closes the map (see
// core/physics/disk/height_map.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/formats/input_problem.h"
#include "core/physics/disk/height_map.h"

namespace touchdown {

struct HeightMapDocument {
    HeightMap map;                      // valid if there are no problems
    std::vector<InputProblem> problems; // with file, line and what is allowed
    std::vector<InputProblem> warnings; // a surface that was turned, names that are not known, remarks not used
    bool valid() const { return problems.empty(); }
};

/// Reads a file of any format. `name` is its name in the problems; `unit` is the value of disk.surface.unit.
HeightMapDocument readHeightMap(const std::filesystem::path& file, const std::string& name,
                                const std::string& unit = {});

/// The text formats; the extension of `name` selects one.
HeightMapDocument readHeightMapText(std::string text, const std::string& name, const std::string& unit = {});

} // namespace touchdown
