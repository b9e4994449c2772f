// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/rail_outline.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

namespace {

/// Far above rounding, far below any feature: lists are complete on their borders [m].
constexpr double borderSlack = 1e-12;

OutlineEdge upward(const RailPoint& a, const RailPoint& b)
{
    const RailPoint& low = a.y <= b.y ? a : b;
    const RailPoint& high = a.y <= b.y ? b : a;
    return {low.x, low.y, high.x - low.x, high.y - low.y, std::min(a.x, b.x), std::max(a.x, b.x), high.y};
}

} // namespace

bool OutlineEdge::meets(const SurfaceBox& box) const
{
    if (xMax < box.x0 || xMin > box.x1 || yMax < box.y0 || y > box.y1) return false;
    // Separated by the edge's own line: the centre lies farther from it than the box reaches.
    const double offset = dx * (box.centreY() - y) - dy * (box.centreX() - x);
    return std::abs(offset) <= std::abs(dx) * box.halfY() + dy * box.halfX() + borderSlack * (std::abs(dx) + dy);
}

RailOutline::RailOutline(const std::vector<RailPoint>& points, int strips, double width)
    : stripsPerMetre_(strips / width), strips_(strips), bounds_{points[0].x, points[0].x, points[0].y, points[0].y}
{
    for (const RailPoint& p : points) {
        bounds_.x0 = std::min(bounds_.x0, p.x);
        bounds_.x1 = std::max(bounds_.x1, p.x);
        bounds_.y0 = std::min(bounds_.y0, p.y);
        bounds_.y1 = std::max(bounds_.y1, p.y);
    }
    first_.assign(static_cast<std::size_t>(strips) + 1, 0);
    const auto forEachStrip = [&](auto&& visit) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const OutlineEdge edge = upward(points[i], points[(i + 1) % points.size()]);
            const int last = strip(edge.yMax + borderSlack);
            for (int s = strip(edge.y - borderSlack); s <= last; ++s) visit(static_cast<std::size_t>(s), edge);
        }
    };
    forEachStrip([&](std::size_t s, const OutlineEdge&) { ++first_[s + 1]; });
    for (std::size_t s = 0; s < static_cast<std::size_t>(strips); ++s) first_[s + 1] += first_[s];
    edges_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    forEachStrip([&](std::size_t s, const OutlineEdge& edge) { edges_[next[s]++] = edge; });
}

int RailOutline::strip(double y) const
{
    return static_cast<int>(std::min(std::max(0.0, y * stripsPerMetre_), strips_ - 1.0));
}

std::span<const OutlineEdge> RailOutline::edges(int strip) const
{
    const auto s = static_cast<std::size_t>(strip);
    return {edges_.data() + first_[s], edges_.data() + first_[s + 1]};
}

// A ray towards smaller x crosses the outline an odd number of times from inside. An edge counts from its lower end up
// to, not including, its upper end, so that a ray through a corner is counted rightly.
bool RailOutline::contains(double x, double y, std::span<const OutlineEdge> edges)
{
    bool inside = false;
    for (const OutlineEdge& edge : edges) {
        if (y < edge.y || y > edge.yMax || x < edge.xMin) continue;
        const double side = edge.dx * (y - edge.y) - edge.dy * (x - edge.x); // negative: the edge is on the ray
        if (side == 0.0 && x <= edge.xMax) return true;
        if (side < 0.0 && y < edge.yMax) inside = !inside;
    }
    return inside;
}

void RailOutline::breaks(const ScanLine& line, int strip, std::vector<double>& out) const
{
    for (const OutlineEdge& edge : edges(strip)) {
        double at;
        if (line.along == ScanAxis::X) {
            if (line.fixed < edge.y || line.fixed > edge.yMax || edge.dy == 0.0) continue;
            at = std::clamp(edge.x + edge.dx * ((line.fixed - edge.y) / edge.dy), edge.xMin, edge.xMax);
        } else {
            if (line.fixed < edge.xMin || line.fixed > edge.xMax || edge.dx == 0.0) continue;
            at = std::clamp(edge.y + edge.dy * ((line.fixed - edge.x) / edge.dx), edge.y, edge.yMax);
        }
        if (at > line.from && at < line.to) out.push_back(at);
    }
}

std::vector<RailPoint> withoutRepetitions(const std::vector<RailPoint>& points)
{
    std::vector<RailPoint> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const RailPoint& next = points[(i + 1) % points.size()];
        if (points[i].x != next.x || points[i].y != next.y) kept.push_back(points[i]);
    }
    return kept;
}

double signedArea(const std::vector<RailPoint>& points)
{
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        twice += (points[i].x - points[0].x) * (points[i + 1].y - points[0].y) -
                 (points[i + 1].x - points[0].x) * (points[i].y - points[0].y);
    }
    return 0.5 * twice;
}

} // namespace touchdown
