// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/ridge_check.h"

#include "core/case/parameters.h"
#include "core/formats/words.h"
#include "core/physics/film/film_grid.h"
#include "core/physics/slider/edge_ridges.h"
#include "core/physics/slider/recess.h"
#include "core/physics/slider/surface_check.h"

namespace touchdown {

std::string ridgeWords(std::size_t edges)
{
    if (edges == 0) return {};
    return counted(edges, "edge") + (edges == 1 ? " has" : " have") + " a ridge narrower than a cell; the stated " +
           "grid error counts " + (edges == 1 ? "it" : "them");
}

void warnOfRidges(const Case& c, std::vector<CaseProblem>& warnings)
{
    if (c.film.accuracy > 0.0 || !surfaceProblems(c.surface).empty()) return;
    const double length = c.slider.length, width = c.slider.width;
    const int nx = c.film.nodes[0] - 1, ny = c.film.nodes[1] - 1;
    const CellGrid grid = c.film.grid == GridKind::Uniform ? uniformGrid(length, width, nx, ny)
                                                           : gradedGrid(c.surface, length, width, nx, ny);
    const std::size_t edges = unresolvedRidges(c.surface, Recess(c.surface, length, width), grid).size();
    if (edges == 0) return;
    warnings.push_back({"film.nodes",
                        ridgeWords(edges) + "; a wall makes a ridge where it begins above the recess of its own rail",
                        {}});
}

} // namespace touchdown
