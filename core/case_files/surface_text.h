// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rails, walls, relations and points of interest of a case file. The numbers of [abs] are parameters: see
// core/case/parameters.h.
//
//   [abs]
//   points_of_interest = [["1.24 mm", "0.5 mm"]]
//
//   [[abs.rail]]                       # where rails overlap, the last one counts
//   recess = "0.2 um"                  # three of them for a ramp: at the first three points
//   points = [["0.1 mm", "0.2 mm"], ["0.4 mm", "0.2 mm"], ["0.4 mm", "0.8 mm"]]
//   walls = [1, 0, 2]                  # on the edge from each point to the next, 0 for none; one number for all edges
//
//   [[abs.wall]]                       # wall 1
//   distance = ["-2 um", "0 um", "3 um"]
//   recess = ["0.2 um", "1 um", "2 um"]
//
//   [[abs.distance]]                   # a distance that edits keep
//   from = "corner 3 of rail 1"        # counted from 1; edge 2 runs from corner 2 to the next
//   to = "edge 1 of rail 2"            # both its corners
//   along = "x"                        # or "y"
//   value = "80 um"                    # to minus from
//
//   [[abs.symmetric]]
//   rails = [1, 2]                     # stay mirror images about the centre line; [3]: symmetric in itself
#pragma once

#include "core/formats/input_problem.h"
#include "core/formats/toml_document.h"
#include "core/physics/slider/air_bearing_surface.h"

#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

inline constexpr std::size_t mostRails = 1000;
inline constexpr std::size_t mostRailPoints = 10000; // of all rails
inline constexpr std::size_t mostWalls = 1000;
inline constexpr std::size_t mostWallPoints = 1000; // of one profile
inline constexpr std::size_t mostInterestPoints = 100;

/// abs.rails = "rail.dat": the surface from a CML file; values in the case override it.
inline constexpr std::string_view railFileKey = "abs.rails";

/// Whether a key belongs to a rail, a wall, a relation or the points of interest: "abs.rail[2].recess",
/// "abs.points_of_interest".
bool isSurfaceKey(std::string_view key);

/// Reads them into `surface` and replaces those that the text contains. The problems name no file.
std::vector<InputProblem> readSurface(const TomlDocument& toml, AirBearingSurface& surface);

/// Their description for the reference.
std::string_view surfaceHelp();

} // namespace touchdown
