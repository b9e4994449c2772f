// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/minimum_spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchdown {

MinimumSpacing::MinimumSpacing(const AirBearingSurface& surface, const Recess& recess)
    : length_(recess.length()), width_(recess.width())
{
    const auto add = [&](double x, double y) { candidates_.push_back({x, y, recess.at(x, y)}); };
    // Crown and camber bend the surface by some tens of nanometres over its length: between neighbours of this lattice by less
    // than a thousandth of that.
    constexpr int lattice = 128;
    for (int j = 0; j <= lattice; ++j)
        for (int i = 0; i <= lattice; ++i) add(length_ * i / lattice, width_ * j / lattice);
    constexpr double beside = 1e-10; // [m], on either side of an edge
    for (const Rail& rail : surface.rails)
        for (std::size_t k = 0; k < rail.points.size(); ++k) {
            const RailPoint& a = rail.points[k];
            const RailPoint& b = rail.points[(k + 1) % rail.points.size()];
            const double dx = b.x - a.x, dy = b.y - a.y, edge = std::hypot(dx, dy);
            if (!(edge > 0.0)) continue;
            const int parts = std::clamp(static_cast<int>(64 * edge / length_), 1, 64);
            for (int m = 0; m <= parts; ++m)
                for (const double side : {-beside, beside}) {
                    // Away from the corners by as much, so that both sides of both edges are met.
                    const double along = std::clamp(edge * m / parts, std::min(beside, 0.5 * edge),
                                                    std::max(edge - beside, 0.5 * edge)) / edge;
                    const double x = a.x + along * dx - side * dy / edge, y = a.y + along * dy + side * dx / edge;
                    if (x >= 0.0 && y >= 0.0 && x <= length_ && y <= width_) add(x, y);
                }
        }
}

MinimumSpacing::Place MinimumSpacing::at(const Attitude& attitude) const
{
    Place best{std::numeric_limits<double>::infinity(), {}};
    for (const Candidate& c : candidates_) {
        const double spacing = above(c, attitude);
        if (spacing < best.spacing) best = {spacing, {c.x, c.y}};
    }
    return best;
}

MinimumSpacing::Place MinimumSpacing::bearing(const Attitude& attitude, double depth) const
{
    const double least = at(attitude).spacing;
    double weights = 0.0, x = 0.0, y = 0.0;
    for (const Candidate& c : candidates_) {
        const double weight = 1.0 - (above(c, attitude) - least) / depth;
        if (weight <= 0.0) continue;
        weights += weight;
        x += weight * c.x;
        y += weight * c.y;
    }
    return {least, {x / weights, y / weights}};
}

} // namespace touchdown
