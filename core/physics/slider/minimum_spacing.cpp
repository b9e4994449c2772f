// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/minimum_spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/physics/slider/rail_wall.h"

namespace touchdown {

namespace {

constexpr int lattice = 128;
constexpr double shortestMove = 1e-13; // on the way down from the nearest point of the list [m]
constexpr double beside = 1e-10;       // of the list, on either side of an edge [m]
constexpr double deepest = 0.1;        // below the nearest point, of the margin, for points that bear nearby [-]

int partsOf(double edge, double sliderLength) { return std::clamp(static_cast<int>(64 * edge / sliderLength), 1, 64); }

/// The distances of a profile's points, and those where it comes as deep as the top of a step, at which walls that lie
/// over another rail end.
std::vector<double> kinksOf(const WallProfile& profile, const AirBearingSurface& surface)
{
    std::vector<double> kinks = profile.distance;
    for (std::size_t k = 1; k < profile.distance.size(); ++k)
        for (const Rail& rail : surface.rails) {
            const double from = profile.recess[k - 1], to = profile.recess[k], top = rail.recess[0];
            if (rail.kind == RailKind::Step && (from < top) != (to < top) && from != top && to != top)
                kinks.push_back(profile.distance[k - 1] +
                                (top - from) / (to - from) * (profile.distance[k] - profile.distance[k - 1]));
        }
    std::ranges::sort(kinks);
    kinks.erase(std::unique(kinks.begin(), kinks.end()), kinks.end());
    return kinks;
}

/// An edge of a rail, or an offset line of its wall.
struct Line {
    Line(SurfacePoint from, SurfacePoint to, std::size_t of)
        : x0(std::min(from.x, to.x)),
          x1(std::max(from.x, to.x)),
          y0(std::min(from.y, to.y)),
          y1(std::max(from.y, to.y)),
          x(from.x),
          y(from.y),
          length(std::hypot(to.x - from.x, to.y - from.y)),
          ux(length > 0.0 ? (to.x - from.x) / length : 0.0),
          uy(length > 0.0 ? (to.y - from.y) / length : 0.0),
          rail(of)
    {}
    double x0, x1, y0, y1; // its box [m]
    double x, y;           // where it begins [m]
    double length;         // [m]
    double ux, uy;         // along it [-]
    std::size_t rail;
};

/// Where two lines of different rails cross.
std::optional<SurfacePoint> crossing(const Line& a, const Line& b)
{
    if (a.rail == b.rail || a.x1 < b.x0 || b.x1 < a.x0 || a.y1 < b.y0 || b.y1 < a.y0) return std::nullopt;
    const double sine = a.ux * b.uy - a.uy * b.ux;
    if (std::abs(sine) < 1e-6) return std::nullopt;
    const double dx = b.x - a.x, dy = b.y - a.y, t = (dx * b.uy - dy * b.ux) / sine, s = (dx * a.uy - dy * a.ux) / sine;
    if (t < 0.0 || s < 0.0 || t > a.length || s > b.length) return std::nullopt;
    return SurfacePoint{a.x + t * a.ux, a.y + t * a.uy};
}

} // namespace

class MinimumSpacing::Bearing {
public:
    Bearing(double least, double depth) : least_(least), depth_(depth) {}
    void add(const Candidate& c, double above)
    {
        const double weight = 1.0 - (above - least_) / depth_;
        if (weight <= 0.0) return;
        weights_ += weight;
        x_ += weight * c.x;
        y_ += weight * c.y;
    }
    SurfacePoint place() const { return {x_ / weights_, y_ / weights_}; }

private:
    double least_, depth_; // of the nearest; of those that bear below it [m]
    double weights_ = 0.0, x_ = 0.0, y_ = 0.0;
};

MinimumSpacing::MinimumSpacing(const AirBearingSurface& surface, const Recess& recess)
    : recess_(recess), length_(recess.length()), width_(recess.width())
{
    const auto add = [&](double x, double y) {
        if (x >= 0.0 && y >= 0.0 && x <= length_ && y <= width_) candidates_.push_back({x, y, recess.at(x, y)});
    };
    // Crown and camber are some tens of nanometres over the length: less than a thousandth of that between neighbours.
    for (int j = 0; j <= lattice; ++j)
        for (int i = 0; i <= lattice; ++i) add(length_ * i / lattice, width_ * j / lattice);
    const auto addAlong = [&](int parts, const auto& at) {
        for (int m = 0; m <= parts; ++m) {
            add(at(m).x, at(m).y);
            if (m > 0) addEdgePart(at(m - 1), at(m));
        }
    };
    std::vector<Line> lines;
    for (std::size_t r = 0; r < surface.rails.size(); ++r) {
        const Rail& rail = surface.rails[r];
        for (std::size_t k = 0; k < rail.points.size(); ++k) {
            const RailPoint& a = rail.points[k];
            const RailPoint& b = rail.points[(k + 1) % rail.points.size()];
            const double dx = b.x - a.x, dy = b.y - a.y, edge = std::hypot(dx, dy);
            if (!(edge > 0.0)) continue;
            lines.emplace_back(SurfacePoint{a.x, a.y}, SurfacePoint{b.x, b.y}, r);
            const int parts = partsOf(edge, length_);
            for (const double side : {-beside, beside})
                addAlong(parts, [&](int m) {
                    // Away from the corners by as much, so that both sides of both edges are met.
                    const double along = std::clamp(edge * m / parts, std::min(beside, 0.5 * edge),
                                                    std::max(edge - beside, 0.5 * edge)) /
                                         edge;
                    return SurfacePoint{a.x + along * dx - side * dy / edge, a.y + along * dy + side * dx / edge};
                });
        }
    }
    // Where walls begin, bend or end, on both sides, since a profile may jump there.
    constexpr double besideWall = 1e-12; // [m]
    std::vector<WallShape> shapes;
    for (const WallProfile& profile : surface.walls) shapes.emplace_back(profile);
    for (std::size_t r = 0; r < surface.rails.size(); ++r)
        for (const RailWall& wall : railWalls(surface.rails[r], static_cast<int>(r), surface.baseRecess, shapes)) {
            const int parts = partsOf(wall.length(), length_);
            const WallProfile& profile = surface.walls[static_cast<std::size_t>(&wall.shape() - shapes.data())];
            for (const double distance : kinksOf(profile, surface)) {
                if (distance != 0.0)
                    lines.emplace_back(wall.onOffsetLine(distance, 0.0, 0.0), wall.onOffsetLine(distance, 1.0, 0.0), r);
                for (const double side : {-besideWall, besideWall})
                    addAlong(parts, [&](int m) {
                        return wall.onOffsetLine(distance + side, static_cast<double>(m) / parts, besideWall);
                    });
            }
        }
    // The quadrants of a crossing.
    for (std::size_t n = 0; n < lines.size(); ++n)
        for (std::size_t k = n + 1; k < lines.size(); ++k)
            if (const auto at = crossing(lines[n], lines[k]))
                for (const double first : {-beside, beside})
                    for (const double second : {-beside, beside})
                        add(at->x + first * lines[n].ux + second * lines[k].ux,
                            at->y + first * lines[n].uy + second * lines[k].uy);
    setBlocks();
}

void MinimumSpacing::addEdgePart(SurfacePoint from, SurfacePoint to)
{
    const auto onSlider = [&](SurfacePoint at) {
        return SurfacePoint{std::clamp(at.x, 0.0, length_), std::clamp(at.y, 0.0, width_)};
    };
    from = onSlider(from);
    to = onSlider(to);
    if (from == to) return;
    const double first = recess_.at(from.x, from.y), last = recess_.at(to.x, to.y),
                 middle = recess_.at(0.5 * (from.x + to.x), 0.5 * (from.y + to.y));
    edges_.push_back({from, to, first, last, std::max(0.5 * (first + last) - middle, 0.0)});
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

MinimumSpacing::Place MinimumSpacing::nearestListed(const Attitude& attitude) const
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

MinimumSpacing::Place MinimumSpacing::at(const Attitude& attitude) const
{
    return lowestBeside(nearestListed(attitude), attitude);
}

MinimumSpacing::Place MinimumSpacing::lowestBeside(const Place& listed, const Attitude& attitude) const
{
    Place nearest = listed;
    if (!std::isfinite(nearest.spacing)) return nearest;
    for (double step = 2.0 * std::max(length_, width_) / lattice; step > shortestMove;) {
        const SurfacePoint from = nearest.at;
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}) {
            const double x = std::clamp(from.x + dx * step, 0.0, length_),
                         y = std::clamp(from.y + dy * step, 0.0, width_);
            if (const double here = above({x, y, recess_.at(x, y)}, attitude); here < nearest.spacing)
                nearest = {here, {x, y}};
        }
        if (nearest.at == from) step *= 0.5;
    }
    // The way from the side of an edge to the edge itself counts for nothing.
    const bool same = std::hypot(nearest.at.x - listed.at.x, nearest.at.y - listed.at.y) < 3.0 * beside;
    return same ? listed : nearest;
}

double NearbySpacing::search(const Attitude& attitude)
{
    searched_ = attitude;
    const MinimumSpacing::Place first = spacing_->nearestListed(attitude);
    const double listed = first.spacing, spacing = spacing_->lowestBeside(first, attitude).spacing;
    down_ = listed - spacing;
    near_.clear();
    // A point that is no nearer than this there comes no nearer than the nearest one within the margin.
    for (const MinimumSpacing::Candidate& c : spacing_->candidates_) {
        const double here = spacing_->above(c, attitude);
        if (here > listed + (2.0 + deepest) * margin_) continue;
        if (here == listed) nearest_ = near_.size();
        near_.push_back(c);
    }
    return spacing;
}

double NearbySpacing::at(const Attitude& attitude)
{
    if (!(margin_ > 0.0)) return spacing_->at(attitude).spacing;
    double listed = 0.0;
    return look(attitude, listed);
}

MinimumSpacing::Place NearbySpacing::bearing(const Attitude& attitude, double depth)
{
    if (!(deepest * margin_ > depth)) return spacing_->bearing(attitude, depth);
    double listed = 0.0;
    const double spacing = look(attitude, listed);
    MinimumSpacing::Bearing mean(listed, depth);
    for (const MinimumSpacing::Candidate& c : near_) mean.add(c, spacing_->above(c, attitude));
    return {spacing, mean.place()};
}

/// `listed`: the spacing of the nearest point of the list.
double NearbySpacing::look(const Attitude& attitude, double& listed)
{
    const auto anew = [&] {
        const double spacing = search(attitude);
        listed = spacing + down_;
        return spacing;
    };
    if (!searched_ || !(displacement(*searched_, attitude, spacing_->length_, spacing_->width_) <= margin_))
        return anew();
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < near_.size(); ++k)
        if (const double here = spacing_->above(near_[k], attitude); here < least) {
            least = here;
            nearest = k;
        }
    if (down_ > shortestMove && nearest != nearest_) return anew();
    listed = least;
    return least - down_;
}

MinimumSpacing::Place MinimumSpacing::bearing(const Attitude& attitude, double depth) const
{
    const Place listed = nearestListed(attitude);
    Bearing mean(listed.spacing, depth);
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        if (1.0 - (bound(blocks_[b], attitude) - listed.spacing) / depth <= 0.0) continue;
        const std::size_t end = std::min((b + 1) * blockSize, candidates_.size());
        for (std::size_t k = b * blockSize; k < end; ++k) mean.add(candidates_[k], above(candidates_[k], attitude));
    }
    return {lowestBeside(listed, attitude).spacing, mean.place()};
}

} // namespace touchdown
