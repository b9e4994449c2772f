// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/meeting_walls.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/physics/slider/rail_wall.h"

namespace touchdown {

namespace {

using Polygon = std::vector<SurfacePoint>;

constexpr double facing = -0.5;     // cosine between the normals of edges that face each other, at most
constexpr double noOverlap = 1e-16; // [m^2]: 10 nm x 10 nm

double across(const SurfacePoint& a, const SurfacePoint& b, const SurfacePoint& p)
{
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Twice the area; positive when the corners run anticlockwise [m^2].
double twiceArea(const Polygon& polygon)
{
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) twice += across(polygon[0], polygon[i], polygon[i + 1]);
    return twice;
}

Polygon anticlockwise(Polygon polygon)
{
    if (twiceArea(polygon) < 0.0) std::ranges::reverse(polygon);
    return polygon;
}

/// The part of a convex polygon on the left of each edge of another (Sutherland and Hodgman 1974); both anticlockwise.
Polygon overlapOf(Polygon polygon, const Polygon& other)
{
    for (std::size_t i = 0; i < other.size() && !polygon.empty(); ++i) {
        const SurfacePoint &a = other[i], &b = other[(i + 1) % other.size()];
        Polygon kept;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const SurfacePoint &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
            const double atP = across(a, b, p), atQ = across(a, b, q);
            if (atP >= 0.0) kept.push_back(p);
            if ((atP < 0.0) == (atQ < 0.0)) continue;
            const double share = atP / (atP - atQ);
            kept.push_back({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)});
        }
        polygon = std::move(kept);
    }
    return polygon;
}

/// One side of a wall as an area.
struct WallArea {
    const RailWall* wall;
    std::size_t rail, edge;
    WallSide side;
    Polygon polygon; // anticlockwise
    SurfaceBox box;

    bool holdsAt(const SurfacePoint& p, double top) const
    {
        if (side == WallSide::Outside) return wall->recessOutside(p.x, p.y) < top;
        return wall->recessInside(p.x, p.y).has_value();
    }
};

SurfaceBox boxOf(const Polygon& polygon)
{
    SurfaceBox box{polygon[0].x, polygon[0].x, polygon[0].y, polygon[0].y};
    for (const SurfacePoint& p : polygon) {
        box.x0 = std::min(box.x0, p.x), box.x1 = std::max(box.x1, p.x);
        box.y0 = std::min(box.y0, p.y), box.y1 = std::max(box.y1, p.y);
    }
    return box;
}

bool apart(const SurfaceBox& a, const SurfaceBox& b)
{
    return a.x1 < b.x0 || b.x1 < a.x0 || a.y1 < b.y0 || b.y1 < a.y0;
}

/// Of a corner that is repeated the last one has the edge.
std::size_t edgeFrom(const std::vector<RailPoint>& points, const SurfacePoint& corner)
{
    const auto last =
        std::find_if(points.rbegin(), points.rend(), [&](auto& p) { return p.x == corner.x && p.y == corner.y; });
    return static_cast<std::size_t>(points.rend() - last) - 1;
}

class Meetings {
public:
    explicit Meetings(const AirBearingSurface& surface);
    std::vector<SurfaceProblem> warnings() const;

private:
    struct Meeting {
        std::size_t edge, otherEdge;
        SurfacePoint at;
    };
    std::optional<SurfacePoint> meetingOf(const WallArea& a, const WallArea& b) const;
    std::optional<std::size_t> topAt(const SurfacePoint& p) const;

    const AirBearingSurface& surface_;
    std::vector<RailOutline> outlines_;
    std::vector<WallShape> shapes_;
    std::vector<RailWall> walls_;
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Meeting>> found_; // of two rails
};

Meetings::Meetings(const AirBearingSurface& surface) : surface_(surface)
{
    for (const WallProfile& profile : surface.walls) shapes_.emplace_back(profile);
    for (std::size_t i = 0; i < surface.rails.size(); ++i) {
        outlines_.emplace_back(surface.rails[i].points, 1, 1.0);
        for (RailWall& wall : railWalls(surface.rails[i], static_cast<int>(i), surface.baseRecess, shapes_))
            walls_.push_back(std::move(wall));
    }
    std::vector<WallArea> areas;
    for (const RailWall& wall : walls_)
        for (const WallSide side : {WallSide::Outside, WallSide::Inside})
            if (Polygon polygon = anticlockwise(wall.corners(side)); !polygon.empty()) {
                const auto rail = static_cast<std::size_t>(wall.rail());
                const SurfaceBox box = boxOf(polygon);
                areas.push_back({&wall, rail, edgeFrom(surface.rails[rail].points, wall.firstCorner()), side,
                                 std::move(polygon), box});
            }
    for (std::size_t i = 0; i < areas.size(); ++i)
        for (std::size_t k = i + 1; k < areas.size(); ++k)
            if (const auto at = meetingOf(areas[i], areas[k]))
                found_[{areas[i].rail, areas[k].rail}].push_back({areas[i].edge, areas[k].edge, *at});
}

/// The rail whose top is seen; nothing on the base.
std::optional<std::size_t> Meetings::topAt(const SurfacePoint& p) const
{
    for (std::size_t i = outlines_.size(); i-- > 0;)
        if (outlines_[i].contains(p.x, p.y)) return i;
    return {};
}

std::optional<SurfacePoint> Meetings::meetingOf(const WallArea& a, const WallArea& b) const
{
    if (a.side != b.side || (a.side == WallSide::Inside && a.rail != b.rail) || apart(a.box, b.box)) return {};
    const SurfacePoint n = a.wall->outwards(), m = b.wall->outwards();
    if (n.x * m.x + n.y * m.y > facing) return {};
    const Polygon overlap = overlapOf(a.polygon, b.polygon);
    if (!(0.5 * twiceArea(overlap) > noOverlap)) return {};
    SurfacePoint middle;
    for (const SurfacePoint& p : overlap) {
        middle.x += p.x / static_cast<double>(overlap.size());
        middle.y += p.y / static_cast<double>(overlap.size());
    }
    const std::optional<std::size_t> top = topAt(middle);
    if (a.side == WallSide::Inside && top != a.rail) return {};
    const double recess = top ? *std::ranges::min_element(surface_.rails[*top].recess.begin(),
                                                          surface_.rails[*top].recess.begin() +
                                                              (surface_.rails[*top].kind == RailKind::Ramp ? 3 : 1))
                              : surface_.baseRecess;
    if (!a.holdsAt(middle, recess) || !b.holdsAt(middle, recess)) return {};
    return middle;
}

std::vector<SurfaceProblem> Meetings::warnings() const
{
    std::vector<SurfaceProblem> warnings;
    for (const auto& [rails, meetings] : found_) {
        const auto number = [](std::size_t index) { return std::to_string(index + 1); };
        const auto& [edge, otherEdge, at] = meetings.front();
        const bool same = rails.first == rails.second;
        const std::string rail = number(rails.first);
        std::string sentence = "Rail " + rail + ": the walls of edge " + number(edge) + " and ";
        sentence +=
            same ? "edge " + number(otherEdge) : "of edge " + number(otherEdge) + " of rail " + number(rails.second);
        if (const std::size_t more = meetings.size() - 1; more > 0)
            sentence += ", and " + std::to_string(more) + (more == 1 ? " more pair," : " more pairs,");
        SurfaceProblem warning{"abs.rail[" + rail + "]", sentence + " run into each other."};
        for (const Meeting& meeting : meetings) warning.places.push_back(meeting.at);
        warnings.push_back(std::move(warning));
    }
    return warnings;
}

} // namespace

std::vector<SurfaceProblem> meetingWalls(const AirBearingSurface& surface) { return Meetings(surface).warnings(); }

} // namespace touchdown
