// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/short_edges.h"

#include <algorithm>

#include "core/numerics/cell_grid.h"
#include "core/physics/slider/part_list.h"

namespace touchdown {

namespace {

/// The width of the cell that holds a place between ascending lines [m].
double cellWidthAt(const std::vector<double>& lines, double place)
{
    const auto next = std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(lines, place) - lines.begin(), 1,
                                                 static_cast<std::ptrdiff_t>(lines.size()) - 1);
    const auto cell = static_cast<std::size_t>(next);
    return lines[cell] - lines[cell - 1];
}

bool fitsInCell(double width, double height, SurfacePoint at, const CellGrid& grid)
{
    return width < cellWidthAt(grid.x, at.x) && height < cellWidthAt(grid.y, at.y);
}

/// The box about some corners of a rail in a row.
struct CornerBox {
    double x0, x1, y0, y1; // [m]

    explicit CornerBox(const RailPoint& p) : x0(p.x), x1(p.x), y0(p.y), y1(p.y) {}
    void add(const RailPoint& p)
    {
        x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
        y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
    }
    bool fitsInCell(const CellGrid& grid) const
    {
        return touchdown::fitsInCell(x1 - x0, y1 - y0, {0.5 * (x0 + x1), 0.5 * (y0 + y1)}, grid);
    }
};

/// The edges to report; each row of short ones is taken as a whole.
std::vector<std::size_t> unresolvedEdges(const std::vector<RailPoint>& points, const CellGrid& grid)
{
    const std::size_t count = points.size();
    const auto at = [&](std::size_t i) -> const RailPoint& { return points[i % count]; };
    std::vector<char> isShort(count);
    for (std::size_t i = 0; i < count; ++i) {
        CornerBox edge(at(i));
        edge.add(at(i + 1));
        const bool repeated = at(i).x == at(i + 1).x && at(i).y == at(i + 1).y;
        isShort[i] = !repeated && edge.fitsInCell(grid);
    }
    const auto longOne = static_cast<std::size_t>(std::ranges::find(isShort, 0) - isShort.begin());
    std::vector<std::size_t> edges;
    // From a long edge on, so that no row is parted by the beginning of the list.
    for (std::size_t k = 1; k <= count; ++k) {
        std::size_t first = longOne + k, last = first;
        if (!isShort[first % count]) continue;
        CornerBox row(at(first));
        for (; last < longOne + count + 1 && isShort[last % count]; ++last) row.add(at(last + 1));
        if (row.fitsInCell(grid))
            for (std::size_t i = first; i < last; ++i) edges.push_back(i % count);
        k = last - longOne;
    }
    std::ranges::sort(edges);
    return edges;
}

} // namespace

std::vector<SurfaceProblem> shortEdges(const AirBearingSurface& surface, const CellGrid& grid)
{
    std::vector<SurfaceProblem> warnings;
    for (std::size_t r = 0; r < surface.rails.size(); ++r) {
        const std::vector<RailPoint>& points = surface.rails[r].points;
        const std::vector<std::size_t> edges = unresolvedEdges(points, grid);
        if (edges.empty()) continue;
        const std::string rail = std::to_string(r + 1);
        SurfaceProblem warning{"abs.rail[" + rail + "]", "Rail " + rail + ": " + partList("edge", edges) +
                                                             (edges.size() == 1 ? " is" : " are") +
                                                             " shorter than a cell of the grid."};
        for (const std::size_t i : edges) {
            const RailPoint &a = points[i], &b = points[(i + 1) % points.size()];
            warning.places.push_back({0.5 * (a.x + b.x), 0.5 * (a.y + b.y)});
        }
        warnings.push_back(std::move(warning));
    }
    return warnings;
}

} // namespace touchdown
