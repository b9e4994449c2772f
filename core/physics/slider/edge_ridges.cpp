// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/edge_ridges.h"

#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/physics/slider/rail_outline.h"
#include "core/physics/slider/recess.h"

namespace touchdown {

namespace {

/// A profile's distances over which it is shallower than its rail, and where it is shallowest [m].
struct RidgeProfile {
    double from, to, crest;
};

/// Where the profile is at this recess, between two points on either side of it [m].
double crossing(const WallProfile& wall, std::size_t before, double recess)
{
    const double d0 = wall.distance[before], d1 = wall.distance[before + 1];
    const double s0 = wall.recess[before], s1 = wall.recess[before + 1];
    return d0 + (d1 - d0) * (recess - s0) / (s1 - s0);
}

std::optional<RidgeProfile> ridgeOf(const WallProfile& wall, double railRecess)
{
    const auto lowest = std::ranges::min_element(wall.recess);
    if (lowest == wall.recess.end() || !(*lowest < railRecess)) return {};
    const std::size_t crest = static_cast<std::size_t>(lowest - wall.recess.begin());
    std::size_t first = crest, last = crest;
    while (first > 0 && wall.recess[first - 1] < railRecess) --first;
    while (last + 1 < wall.recess.size() && wall.recess[last + 1] < railRecess) ++last;
    RidgeProfile ridge{wall.distance[first], wall.distance[last], wall.distance[crest]};
    if (first > 0) ridge.from = crossing(wall, first - 1, railRecess);
    if (last + 1 < wall.recess.size()) ridge.to = crossing(wall, last, railRecess);
    return ridge;
}

/// The width of the cell that holds a place, between lines [m].
double cellAt(std::span<const double> lines, double place)
{
    const auto inner = lines.subspan(1, lines.size() - 2);
    const auto next = static_cast<std::size_t>(std::ranges::upper_bound(inner, place) - inner.begin());
    return lines[next + 1] - lines[next];
}

/// An edge in its own coordinates: t along it, n outwards.
struct Edge {
    RailPoint from;
    double ux, uy, nx, ny, length; // directions [-], length [m]

    Edge(const RailPoint& a, const RailPoint& b, double turn) : from(a), length(std::hypot(b.x - a.x, b.y - a.y))
    {
        ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
        nx = turn * uy, ny = -turn * ux;
    }
    SurfacePoint at(double t, double n) const { return {from.x + t * ux + n * nx, from.y + t * uy + n * ny}; }
};

bool isUnresolved(const Edge& edge, const WallProfile& wall, const RidgeProfile& ridge, const Recess& recess,
                  const CellGrid& grid)
{
    constexpr int places = 16;      // along the edge
    constexpr double beside = 1e-9; // [m]: so far from a jump of the surface
    for (int k = 0; k < places; ++k) {
        const double t = edge.length * (k + 0.5) / places;
        const SurfacePoint place = edge.at(t, ridge.crest);
        if (place.x < 0.0 || place.x > recess.length() || place.y < 0.0 || place.y > recess.width()) continue;
        const auto gapAt = [&](double n) {
            const SurfacePoint p = edge.at(t, n);
            return comparedGap(recess.at(p.x, p.y));
        };
        const double crest = std::min(gapAt(ridge.crest), gapAt(ridge.crest + beside));
        const double behind = std::max(gapAt(ridge.to), gapAt(wall.distance.back() + beside));
        if (gapAt(ridge.from - beside) < ridgeContrast * crest || behind < ridgeContrast * crest) continue;
        const double cell = std::abs(edge.nx) * cellAt(grid.x, place.x) + std::abs(edge.ny) * cellAt(grid.y, place.y);
        if (ridge.to - ridge.from < cell) return true;
    }
    return false;
}

} // namespace

std::vector<RailEdge> unresolvedRidges(const AirBearingSurface& surface, const Recess& recess, const CellGrid& grid)
{
    std::vector<RailEdge> edges;
    for (std::size_t r = 0; r < surface.rails.size(); ++r) {
        const Rail& rail = surface.rails[r];
        if (rail.kind == RailKind::Ramp || rail.recess[0] >= surface.baseRecess) continue; // no walls: recess.h
        const double turn = signedArea(rail.points) < 0.0 ? -1.0 : 1.0;
        for (std::size_t i = 0; i < rail.points.size(); ++i) {
            const RailPoint &from = rail.points[i], &to = rail.points[(i + 1) % rail.points.size()];
            if (from.wall == 0 || (from.x == to.x && from.y == to.y)) continue;
            const WallProfile& wall = surface.walls[static_cast<std::size_t>(from.wall - 1)];
            const std::optional<RidgeProfile> ridge = ridgeOf(wall, rail.recess[0]);
            if (ridge && isUnresolved({from, to, turn}, wall, *ridge, recess, grid)) edges.push_back({r, i});
        }
    }
    return edges;
}

AirBearingSurface withWiderWalls(const AirBearingSurface& surface, std::span<const RailEdge> edges, double times)
{
    AirBearingSurface result = surface;
    for (const RailEdge& edge : edges) {
        RailPoint& point = result.rails[edge.rail].points[edge.point];
        WallProfile wider = surface.walls[static_cast<std::size_t>(point.wall - 1)];
        for (double& distance : wider.distance) distance *= times;
        result.walls.push_back(std::move(wider));
        point.wall = static_cast<int>(result.walls.size());
    }
    return result;
}

} // namespace touchdown
