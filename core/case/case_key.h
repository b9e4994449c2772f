// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every number of a case by one name: a key of its file (core/case/parameters.h), or a number of its air bearing
// surface, counted from 1 as in the file.
//
//   abs.rail[2].recess             at its first point; a ramp keeps its slopes
//   abs.rail[2].recess[3]          of a ramp, at its third point
//   abs.rail[2].x, y               middle of the rectangle around it; the rail is moved
//   abs.rail[2].length, width      of that rectangle along x and y; the rail is stretched about its middle
//   abs.rail[2].point[3].x, y      a corner
//   abs.rail[2].wall[3]            a whole number: the wall on the edge from corner 3 to the next, 0 for none
//   abs.wall[1].distance[2]        of a profile's point from the edge
//   abs.wall[1].recess[2]          there
//   abs.wall[1].shift              the distance of its first point; the others are moved by as much
//   abs.distance[1].value          a kept distance; its place `to` moves
//   abs.points_of_interest[1].x, y
//
// x runs from the leading edge, y from the inner edge; all are lengths [m], at most 1 m.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/case/parameters.h"

namespace touchdown {

/// The parameter of a key in this case, or why there is none, in a sentence without the key. A number of the surface
/// refers to its place: after an insertion or a removal of rails, points or walls it must be asked for again.
std::variant<Parameter, std::string> caseKey(const Case& c, std::string_view key);

/// The same, but only a real number that has a part in the case.
std::variant<Parameter, std::string> numberKey(const Case& c, std::string_view key);

/// The same, but a key of the computation (run., spectrum.) is none of the scene.
std::variant<Parameter, std::string> sceneKey(const Case& c, std::string_view key);

/// One kind of these keys, for the reference.
struct SurfaceNumberForm {
    std::string key; // "abs.rail[N].point[K].x"
    std::string help;
};
std::span<const SurfaceNumberForm> surfaceNumberForms();

} // namespace touchdown
