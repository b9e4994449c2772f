// SPDX-License-Identifier: GPL-3.0-or-later
//
// rail.dat, the established program's file of a slider and its air bearing surface. Lengths in m, angles in rad:
//
//   two header lines
//   length width thickness
//   number of rails, number of wall profiles
//   per rail:   points type (1 step, 0 ramp); per point x y wall; one recess (step) or three (ramp)
//   if there are profiles: the number of points of each; per profile the distances, then the recesses
//   taper length, taper angle, base recess
//   crown, camber, twist
//   x of the points of interest; y of them (may be missing)
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/input_problem.h"
#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

/// The content of a rail.dat.
struct CmlRails {
    double length = 0.0;    // of the slider [m]
    double width = 0.0;     // [m]
    double thickness = 0.0; // [m]
    AirBearingSurface surface;
    std::map<std::string, int> lines;   // line of the file of each number that is a parameter of a case, by its key
    std::vector<int> railLines;         // line on which each rail begins
    std::vector<int> wallLines;         // and each profile's distances
    std::vector<InputProblem> problems; // the values are valid only if there are none
    std::vector<InputProblem> warnings;
    bool valid() const { return problems.empty(); }
};

/// `file` appears in the problems. Checks numbers and counts; core/physics/slider/surface_check.h checks the shape of
/// the rails.
CmlRails readCmlRails(std::string_view text, const std::string& file);

/// The text of a rail.dat that reads back as the same surface, to the last bit.
std::string formatCmlRails(double length, double width, double thickness, const AirBearingSurface& surface);

} // namespace touchdown
