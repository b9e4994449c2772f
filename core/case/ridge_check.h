// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ridges that the grid of a case does not resolve (core/physics/slider/edge_ridges.h).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace touchdown {

struct Case;
struct CaseProblem;

/// "3 edges have a ridge narrower than a cell; ..."; "" for none.
std::string ridgeWords(std::size_t edges);

/// For a film case with a given grid: on the grid before it is adapted to the pressure. Nothing for a surface with
/// problems, nor where film.accuracy chooses the grid.
void warnOfRidges(const Case& c, std::vector<CaseProblem>& warnings);

} // namespace touchdown
