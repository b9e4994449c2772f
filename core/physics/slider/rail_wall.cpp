// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/rail_wall.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchdown {

namespace {

// Neighbouring walls overlap on their border, and a wall its own edge, so that rounding leaves no gap.
constexpr double overlap = 1e-15; // [m]
// Breaks on borders are kept, and a box that touches a kept break meets the wall: far above rounding, below features.
constexpr double margin = 1e-13;    // [m]
constexpr double wallSlack = 1e-12; // [m]

double spread(double sine, double cosine, double own, double neighbour)
{
    // Where the outline runs straight on, the offset lines are parallel: the wall ends square to the edge.
    if (std::abs(sine) < 1e-9) return cosine > 0.0 ? 0.0 : 1e9;
    const double halfTangent = cosine > 0.0 ? sine / (1.0 + cosine) : (1.0 - cosine) / sine;
    return (neighbour / own - 1.0) / sine + halfTangent;
}

SurfacePoint direction(const RailPoint& a, const RailPoint& b)
{
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    return {(b.x - a.x) / length, (b.y - a.y) / length};
}

} // namespace

WallShape::WallShape(const WallProfile& profile)
    : distance_(profile.distance), recess_(profile.recess), lowest_(profile.recess)
{
    for (std::size_t i = lowest_.size() - 1; i > 0; --i) lowest_[i - 1] = std::min(lowest_[i - 1], lowest_[i]);
    maximum_ = *std::max_element(recess_.begin(), recess_.end());
}

std::size_t WallShape::after(double distance) const
{
    return static_cast<std::size_t>(std::upper_bound(distance_.begin(), distance_.end(), distance) - distance_.begin());
}

double WallShape::between(std::size_t next, double distance) const
{
    const double part = (distance - distance_[next - 1]) / (distance_[next] - distance_[next - 1]);
    return recess_[next - 1] + part * (recess_[next] - recess_[next - 1]);
}

double WallShape::at(double distance) const
{
    const std::size_t next = after(distance);
    return next == distance_.size() ? recess_.back() : between(next, distance);
}

double WallShape::minimumFrom(double distance) const
{
    if (distance <= inner()) return lowest_.front();
    const std::size_t next = after(distance);
    return next == distance_.size() ? lowest_.back() : std::min(between(next, distance), lowest_[next]);
}

WallSpread wallSpread(const SurfacePoint& own, const SurfacePoint& next, double turn, const WallShape& shape,
                      const WallShape* neighbour)
{
    const double sine = turn * (own.x * next.y - own.y * next.x);
    const double cosine = own.x * next.x + own.y * next.y;
    const double outside = neighbour ? std::max(0.0, neighbour->outer()) : 0.0;
    const double inside = neighbour ? std::min(0.0, neighbour->inner()) : 0.0;
    return {shape.outer() > 0.0 ? spread(sine, cosine, shape.outer(), outside) : 0.0,
            shape.inner() < 0.0 ? spread(sine, cosine, shape.inner(), inside) : 0.0};
}

RailWall::RailWall(const RailPoint& a, const RailPoint& b, double turn, const WallShape& shape, WallSpread start,
                   WallSpread end, int rail)
    : x_(a.x), y_(a.y), length_(std::hypot(b.x - a.x, b.y - a.y)), start_(start), end_(end), shape_(&shape), rail_(rail)
{
    ux_ = (b.x - a.x) / length_;
    uy_ = (b.y - a.y) / length_;
    nx_ = turn * uy_;
    ny_ = -turn * ux_;
}

std::vector<SurfacePoint> RailWall::corners(WallSide side) const
{
    if (!has(side)) return {};
    double n = end(side);
    const double closing = start_[side] + end_[side]; // of the length, per unit of n
    const bool triangle = length_ + closing * n < 0.0;
    if (triangle) n = -length_ / closing;
    const auto at = [&](double t, double away) {
        return SurfacePoint{x_ + t * ux_ + away * nx_, y_ + t * uy_ + away * ny_};
    };
    std::vector<SurfacePoint> corners{at(0.0, 0.0), at(length_, 0.0), at(length_ + end_[side] * n, n)};
    if (!triangle) corners.push_back(at(-start_[side] * n, n));
    return corners;
}

SurfacePoint RailWall::onOffsetLine(double distance, double share, double inset) const
{
    const WallSide side = distance > 0.0 ? WallSide::Outside : WallSide::Inside;
    const double from = -start_[side] * distance + inset, to = length_ + end_[side] * distance - inset;
    const double t = from + share * (to - from);
    return {x_ + t * ux_ + distance * nx_, y_ + t * uy_ + distance * ny_};
}

std::vector<RailWall> railWalls(const Rail& rail, int index, double baseRecess, const std::vector<WallShape>& shapes)
{
    std::vector<RailWall> walls;
    if (rail.kind == RailKind::Ramp || rail.recess[0] >= baseRecess) return walls;
    const std::vector<RailPoint> points = withoutRepetitions(rail.points);
    const std::size_t count = points.size();
    const double turn = signedArea(points) < 0.0 ? -1.0 : 1.0;
    const auto shapeOf = [&](std::size_t i) -> const WallShape* {
        return points[i].wall > 0 ? &shapes[static_cast<std::size_t>(points[i].wall - 1)] : nullptr;
    };
    for (std::size_t i = 0; i < count; ++i) {
        const WallShape* shape = shapeOf(i);
        if (!shape) continue;
        const std::size_t before = (i + count - 1) % count;
        const std::size_t after = (i + 1) % count;
        const SurfacePoint previous = direction(points[before], points[i]);
        const SurfacePoint own = direction(points[i], points[after]);
        const SurfacePoint next = direction(points[after], points[(i + 2) % count]);
        const WallSpread start = wallSpread(previous, own, turn, *shape, shapeOf(before));
        const WallSpread end = wallSpread(own, next, turn, *shape, shapeOf(after));
        walls.emplace_back(points[i], points[after], turn, *shape, start, end, index);
    }
    return walls;
}

RailWall::Place RailWall::place(double x, double y) const
{
    return {(x - x_) * ux_ + (y - y_) * uy_, (x - x_) * nx_ + (y - y_) * ny_};
}

// Beyond the ends of the edge, to the corner.
double RailWall::distance(Place p) const
{
    const double beyond = p.t < 0.0 ? p.t : p.t > length_ ? p.t - length_ : 0.0;
    if (beyond == 0.0) return p.n;
    return std::copysign(std::sqrt(beyond * beyond + p.n * p.n), p.n);
}

// True between the borders, from the edge to the end of the wall.
bool RailWall::covers(Place p, WallSide side, double margin) const
{
    const double start = start_[side];
    const double end = end_[side];
    if (side == WallSide::Outside ? p.n < -margin || p.n > shape_->outer() + margin
                                  : p.n > margin || p.n < shape_->inner() - margin)
        return false;
    return p.t + start * p.n >= -margin * (1.0 + std::abs(start)) &&
           p.t - end * p.n <= length_ + margin * (1.0 + std::abs(end));
}

double RailWall::recessOutside(double x, double y) const
{
    constexpr double none = std::numeric_limits<double>::infinity();
    Place p = place(x, y);
    if (!covers(p, WallSide::Outside, overlap)) return none;
    p.n = std::max(0.0, p.n);
    const double d = distance(p);
    return d < shape_->inner() || d > shape_->outer() ? none : shape_->at(d);
}

std::optional<double> RailWall::recessInside(double x, double y) const
{
    Place p = place(x, y);
    if (!covers(p, WallSide::Inside, overlap)) return {};
    p.n = std::min(-0.0, p.n);
    const double d = distance(p);
    if (d < shape_->inner() || d > shape_->outer()) return {};
    return shape_->at(d);
}

SurfaceBox RailWall::bounds() const
{
    const double reach = std::max({0.0, shape_->outer(), -shape_->inner()}) + wallSlack;
    const double x = x_ + length_ * ux_;
    const double y = y_ + length_ * uy_;
    return {std::min(x_, x) - reach, std::max(x_, x) + reach, std::min(y_, y) - reach, std::max(y_, y) + reach};
}

bool RailWall::meets(const SurfaceBox& box, WallSide side) const
{
    const Place c = place(box.centreX(), box.centreY());
    const double halfX = box.halfX() + wallSlack;
    const double halfY = box.halfY() + wallSlack;
    const double tHalf = std::abs(ux_) * halfX + std::abs(uy_) * halfY;
    const double nHalf = std::abs(nx_) * halfX + std::abs(ny_) * halfY;
    const double nMin = side == WallSide::Outside ? 0.0 : shape_->inner();
    const double nMax = side == WallSide::Outside ? shape_->outer() : 0.0;
    const double reach = nMax - nMin;
    if (c.n + nHalf < nMin || c.n - nHalf > nMax || c.t + tHalf < -reach || c.t - tHalf > length_ + reach) return false;

    // Beyond one of the borders.
    const double start = start_[side];
    const double end = end_[side];
    const double startHalf = std::abs(ux_ + start * nx_) * halfX + std::abs(uy_ + start * ny_) * halfY;
    const double endHalf = std::abs(ux_ - end * nx_) * halfX + std::abs(uy_ - end * ny_) * halfY;
    return c.t + start * c.n + startHalf >= 0.0 && c.t - end * c.n - endHalf <= length_;
}

double RailWall::lowestOutside(const SurfaceBox& box) const
{
    const Place c = place(box.centreX(), box.centreY());
    const double nHalf = std::abs(nx_) * box.halfX() + std::abs(ny_) * box.halfY() + wallSlack;
    return shape_->minimumFrom(std::max(0.0, c.n - nHalf));
}

/// A line in the coordinates of the edge: the point at `from + along` is (t, n) = at0 + along (tRuns, nRuns).
struct RailWall::Crossing {
    const ScanLine& line;
    WallSide side;
    Place at0;
    double tRuns, nRuns;
    std::vector<double>& out;

    Place place(double along) const { return {at0.t + along * tRuns, at0.n + along * nRuns}; }
};

void RailWall::breaks(const ScanLine& line, WallSide side, std::vector<double>& out) const
{
    const bool alongX = line.along == ScanAxis::X;
    // Measured from the first corner, not from the end of the line: rounding stays that of the wall.
    const Place from = alongX ? place(line.from, line.fixed) : place(line.fixed, line.from);
    const Place to = alongX ? place(line.to, line.fixed) : place(line.fixed, line.to);
    const auto [nMin, nMax] = std::minmax(from.n, to.n);
    const auto [tMin, tMax] = std::minmax(from.t, to.t);
    if (side == WallSide::Outside ? nMin > shape_->outer() + margin || nMax < -margin
                                  : nMin > margin || nMax < shape_->inner() - margin)
        return;
    const Place at0 = alongX ? place(x_, line.fixed) : place(line.fixed, y_);
    const Crossing crossing{line, side, at0, line.runs(ux_, uy_), line.runs(nx_, ny_), out};

    border(crossing, false);
    border(crossing, true);
    const bool roundStart = tMin <= 0.0 && start_[side] * end(side) > 0.0;
    const bool roundEnd = tMax >= length_ && end_[side] * end(side) > 0.0;
    for (const double d : shape_->distances()) {
        if (side == WallSide::Outside ? d <= 0.0 : d >= 0.0) continue; // 0 is the edge itself
        if (d >= nMin - margin && d <= nMax + margin) offsetLine(crossing, d);
        if (roundStart) arc(crossing, d, false);
        if (roundEnd) arc(crossing, d, true);
    }
}

void RailWall::keep(const Crossing& crossing, double along) const
{
    const double at = crossing.line.runs(x_, y_) + along;
    if (at <= crossing.line.from || at >= crossing.line.to) return;
    const Place p = crossing.place(along);
    const double reach = std::abs(end(crossing.side)) + margin; // a slanting border extends beyond the wall
    if (p.t >= -reach && p.t <= length_ + reach && covers(p, crossing.side, margin)) crossing.out.push_back(at);
}

void RailWall::offsetLine(const Crossing& crossing, double d) const
{
    if (crossing.nRuns == 0.0) return;
    const double along = (d - crossing.at0.n) / crossing.nRuns;
    const double t = crossing.place(along).t;
    if (t >= -margin && t <= length_ + margin) keep(crossing, along);
}

void RailWall::arc(const Crossing& crossing, double d, bool atEnd) const
{
    // From the corner the line runs at the distance `across`.
    const double cornerT = atEnd ? length_ : 0.0;
    const Place start{crossing.at0.t - cornerT, crossing.at0.n};
    const double across = start.t * crossing.nRuns - start.n * crossing.tRuns;
    const double foot = -(start.t * crossing.tRuns + start.n * crossing.nRuns);
    const double radius = std::abs(d);
    if (std::abs(across) > radius) return;
    const double half = std::sqrt((radius - across) * (radius + across));
    for (const double along : {foot - half, foot + half}) {
        const double t = crossing.place(along).t;
        if (atEnd ? t >= length_ - margin : t <= margin) keep(crossing, along);
    }
}

void RailWall::border(const Crossing& crossing, bool atEnd) const
{
    // t = slope n from the corner.
    const double slope = atEnd ? end_[crossing.side] : -start_[crossing.side];
    const double runs = crossing.tRuns - slope * crossing.nRuns;
    if (runs == 0.0) return;
    keep(crossing, ((atEnd ? length_ : 0.0) - crossing.at0.t + slope * crossing.at0.n) / runs);
}

} // namespace touchdown
