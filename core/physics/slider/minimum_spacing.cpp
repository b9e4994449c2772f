// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/minimum_spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchdown {

namespace {

constexpr double beside = 1e-10; // [m], on either side of an edge

/// Distances inside an edge at which its top may end: 0, and where a profile that reaches into the rail has a corner.
std::vector<double> depthsOf(const RailPoint& edge, const std::vector<WallProfile>& walls)
{
    std::vector<double> depths{0.0};
    if (edge.wall > 0)
        for (const double distance : walls[static_cast<std::size_t>(edge.wall) - 1].distance)
            if (distance < 0.0) depths.push_back(-distance);
    return depths;
}

/// Points on either side of the lines at those distances, and where the lines of neighbours meet.
std::vector<SurfacePoint> placesOf(const Rail& rail, const std::vector<WallProfile>& walls, double length)
{
    std::vector<SurfacePoint> places;
    const std::size_t count = rail.points.size();
    double area = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        const RailPoint &a = rail.points[k], &b = rail.points[(k + 1) % count];
        area += a.x * b.y - b.x * a.y;
    }
    const double turn = area < 0.0 ? -1.0 : 1.0;
    SurfacePoint normal{0.0, 0.0}, before{0.0, 0.0}; // into the rail, of the edge and of the one before it
    for (std::size_t k = 0; k <= count; ++k) {
        const RailPoint &a = rail.points[k % count], &b = rail.points[(k + 1) % count];
        const double dx = b.x - a.x, dy = b.y - a.y, edge = std::hypot(dx, dy);
        if (!(edge > 0.0)) continue;
        before = normal;
        normal = {-turn * dy / edge, turn * dx / edge};
        const std::vector<double> depths = depthsOf(a, walls);
        const int parts = std::clamp(static_cast<int>(64 * edge / length), 1, 64);
        for (std::size_t d = 0; k < count && d < depths.size(); ++d)
            for (int m = 0; m <= parts; ++m)
                for (const double in : {depths[d] - beside, depths[d] + beside}) {
                    // Away from the corners by as much, so that both sides of both edges are met.
                    const double along = std::clamp(edge * m / parts, std::min(beside, 0.5 * edge),
                                                    std::max(edge - beside, 0.5 * edge)) /
                                         edge;
                    places.push_back({a.x + along * dx + in * normal.x, a.y + along * dy + in * normal.y});
                }
        const double sine = before.x * normal.y - before.y * normal.x;
        if (k == 0 || std::abs(sine) < 1e-3) continue;
        for (const double first : depthsOf(rail.points[k - 1], walls))
            for (const double second : depths) {
                if (first == 0.0 && second == 0.0) continue;
                for (const double p : {first - beside, first + beside})
                    for (const double q : {second - beside, second + beside})
                        places.push_back(
                            {a.x + (p * normal.y - q * before.y) / sine, a.y + (q * before.x - p * normal.x) / sine});
            }
    }
    return places;
}

} // namespace

MinimumSpacing::MinimumSpacing(const AirBearingSurface& surface, const Recess& recess)
    : length_(recess.length()), width_(recess.width())
{
    const auto add = [&](double x, double y) { candidates_.push_back({x, y, recess.at(x, y)}); };
    // Crown and camber are some tens of nanometres over the length: less than a thousandth of that between neighbours.
    constexpr int lattice = 128;
    for (int j = 0; j <= lattice; ++j)
        for (int i = 0; i <= lattice; ++i) add(length_ * i / lattice, width_ * j / lattice);
    for (const Rail& rail : surface.rails)
        for (const SurfacePoint& point : placesOf(rail, surface.walls, length_))
            if (point.x >= 0.0 && point.y >= 0.0 && point.x <= length_ && point.y <= width_) add(point.x, point.y);
    setBlocks();
}

void MinimumSpacing::setBlocks()
{
    for (std::size_t first = 0; first < candidates_.size(); first += blockSize) {
        const Candidate& c = candidates_[first];
        Block block{c.x, c.x, c.y, c.y, c.recess};
        for (std::size_t k = first; k < std::min(first + blockSize, candidates_.size()); ++k) {
            const auto& [x, y, recess] = candidates_[k];
            block = {std::min(block.x0, x), std::max(block.x1, x), std::min(block.y0, y), std::max(block.y1, y),
                     std::min(block.recess, recess)};
        }
        blocks_.push_back(block);
    }
}

MinimumSpacing::Place MinimumSpacing::at(const Attitude& attitude) const
{
    double spacing = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0; // of all that come so near, the first
    const auto look = [&](std::size_t block) {
        const std::size_t end = std::min((block + 1) * blockSize, candidates_.size());
        for (std::size_t k = block * blockSize; k < end; ++k) {
            const double here = above(candidates_[k], attitude);
            if (here < spacing || (here == spacing && k < nearest)) {
                spacing = here;
                nearest = k;
            }
        }
    };
    // First where it seems lowest: then little is left to look at.
    std::size_t lowest = 0;
    double least = spacing;
    for (std::size_t b = 0; b < blocks_.size(); ++b)
        if (const double here = bound(blocks_[b], attitude); here < least) {
            least = here;
            lowest = b;
        }
    look(lowest);
    for (std::size_t b = 0; b < blocks_.size(); ++b)
        if (bound(blocks_[b], attitude) <= spacing) look(b);
    return {spacing, {candidates_[nearest].x, candidates_[nearest].y}};
}

MinimumSpacing::Place MinimumSpacing::bearing(const Attitude& attitude, double depth) const
{
    const double least = at(attitude).spacing;
    double weights = 0.0, x = 0.0, y = 0.0;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        if (1.0 - (bound(blocks_[b], attitude) - least) / depth <= 0.0) continue;
        const std::size_t end = std::min((b + 1) * blockSize, candidates_.size());
        for (std::size_t k = b * blockSize; k < end; ++k) {
            const Candidate& c = candidates_[k];
            const double weight = 1.0 - (above(c, attitude) - least) / depth;
            if (weight <= 0.0) continue;
            weights += weight;
            x += weight * c.x;
            y += weight * c.y;
        }
    }
    return {least, {x / weights, y / weights}};
}

} // namespace touchdown
