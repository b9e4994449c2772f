// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/disk_clearance.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

namespace {

constexpr int knownLevels = 7;               // the recess is sampled in 128 x 128 tiles
constexpr int deepest = 20;                  // level of the smallest boxes
constexpr int edgeLevel = 9;                 // from which edges are left to lookAlong
constexpr int deepestOfEdges = 10;           // halvings of such a part
constexpr int tileParts = 16;                // along each side of a tile that edges cross, for its least recess
constexpr double allowed = 1.0 / 1000.0;     // of the disk's range of heights
constexpr std::size_t mostBoxes = 200000;    // looked at; beyond, the least gap found so far counts
constexpr double firstStep = 0x1p-11;        // of the search downhill, of the slider's sides
constexpr double lastStep = firstStep / 512; // and where it ends
constexpr double rounding = 1e-15;           // of a recess [m]

} // namespace

DiskClearance::DiskClearance(const Recess& recess, const MinimumSpacing& spacing, const DiskTopography& disk,
                             const Velocity& velocity)
    : recess_(recess), spacing_(spacing), disk_(disk), velocity_(velocity)
{
    if (disk_.flat()) return;
    for (int level = 0; level <= knownLevels; ++level) least_.emplace_back(std::size_t{1} << (2 * level), 0.0F);
    const int tiles = 1 << knownLevels;
    for (int j = 0; j < tiles; ++j)
        for (int i = 0; i < tiles; ++i) {
            const Sides tile = sidesOf({0.0, knownLevels, knownLevels, i, j});
            double least;
            if (isSmooth(tile)) {
                const Plane plane = planeOf(tile);
                least = plane.recess - std::abs(plane.slopeX) * tile.halfLength -
                        std::abs(plane.slopeY) * tile.halfWidth - plane.slack;
            } else {
                least = leastRecess(tile, tileParts);
            }
            least_.back()[static_cast<std::size_t>(j * tiles + i)] = std::nextafter(static_cast<float>(least), -1.0F);
        }
    for (int level = knownLevels; level-- > 0;)
        for (int j = 0; j < 1 << level; ++j)
            for (int i = 0; i < 1 << level; ++i) {
                const auto& below = least_[static_cast<std::size_t>(level) + 1];
                const auto child = [&](int right, int up) {
                    return below[static_cast<std::size_t>((2 * j + up) * (2 << level) + 2 * i + right)];
                };
                least_[static_cast<std::size_t>(level)][static_cast<std::size_t>(j * (1 << level) + i)] =
                    std::min({child(0, 0), child(1, 0), child(0, 1), child(1, 1)});
            }
}

DiskClearance::Sides DiskClearance::sidesOf(const Box& box) const
{
    const double halfLength = 0.5 * recess_.length() / (1 << box.levelX),
                 halfWidth = 0.5 * recess_.width() / (1 << box.levelY);
    return {(2 * box.i + 1) * halfLength, (2 * box.j + 1) * halfWidth, halfLength, halfWidth};
}

bool DiskClearance::isSmooth(const Sides& s) const
{
    return recess_.isSmooth(s.x - s.halfLength, s.x + s.halfLength, s.y - s.halfWidth, s.y + s.halfWidth);
}

/// Of a smooth box, where the recess is a quadratic form.
DiskClearance::Plane DiskClearance::planeOf(const Sides& s) const
{
    const auto at = [&](double right, double up) {
        return recess_.at(s.x + right * s.halfLength, s.y + up * s.halfWidth);
    };
    const double middle = at(0.0, 0.0), left = at(-1.0, 0.0), right = at(1.0, 0.0), down = at(0.0, -1.0),
                 up = at(0.0, 1.0);
    const double bent = std::abs(left + right - 2.0 * middle) + std::abs(down + up - 2.0 * middle) +
                        2.0 * std::abs(at(1.0, 1.0) - right - up + middle);
    return {middle, 0.5 * (right - left) / s.halfLength, 0.5 * (up - down) / s.halfWidth, 0.5 * bent + rounding};
}

/// Of the corners of `parts` by `parts` parts of a box.
double DiskClearance::leastRecess(const Sides& s, int parts) const
{
    double least = recess_.at(s.x, s.y);
    for (int m = 0; m <= parts; ++m)
        for (int k = 0; k <= parts; ++k)
            least = std::min(least, recess_.at(s.x + (2.0 * k / parts - 1.0) * s.halfLength,
                                               s.y + (2.0 * m / parts - 1.0) * s.halfWidth));
    return least;
}

double DiskClearance::lift(const Attitude& a, double x, double y) const
{
    return a.height + a.pitch * (recess_.length() - x) - a.roll * (y - 0.5 * recess_.width());
}

DiskClearance::Found DiskClearance::gapAt(const Attitude& attitude, double x, double y, double time) const
{
    return {recess_.at(x, y) + lift(attitude, x, y) - diskHeight({x, y}, time), x, y};
}

double DiskClearance::highestUnder(const Sides& s, double time) const
{
    const double x = s.x - velocity_.x * time, y = s.y - velocity_.y * time;
    return disk_.upperBound(x - s.halfLength, x + s.halfLength, y - s.halfWidth, y + s.halfWidth);
}

DiskClearance::DiskUnder DiskClearance::under(const Sides& s, double time) const
{
    const double x = s.x - velocity_.x * time, y = s.y - velocity_.y * time;
    return {disk_.point(x, y), disk_.curvature(x - s.halfLength, x + s.halfLength, y - s.halfWidth, y + s.halfWidth)};
}

double DiskClearance::leastOf(const Box& box) const
{
    // Up to the known levels both are the same.
    const int known = std::min(box.levelX, knownLevels);
    return least_[static_cast<std::size_t>(known)][static_cast<std::size_t>(
        (box.j >> (box.levelY - known)) * (1 << known) + (box.i >> (box.levelX - known)))];
}

DiskClearance::Box DiskClearance::boxOf(int levelX, int levelY, int i, int j, const Attitude& attitude,
                                        double time) const
{
    Box box{0.0, levelX, levelY, i, j};
    const Sides s = sidesOf(box);
    box.bound = leastOf(box) +
                lift(attitude, s.x + std::copysign(s.halfLength, attitude.pitch),
                     s.y + std::copysign(s.halfWidth, attitude.roll)) -
                highestUnder(s, time);
    return box;
}

/// From the tangents in the middle of a box, where the disk is at `disk`.
double DiskClearance::boundOf(const Plane& plane, const Sides& s, const Attitude& attitude, const DiskUnder& disk) const
{
    return plane.recess + lift(attitude, s.x, s.y) - disk.height -
           std::abs(plane.slopeX - attitude.pitch - disk.slopeX) * s.halfLength -
           std::abs(plane.slopeY - attitude.roll - disk.slopeY) * s.halfWidth -
           0.5 * (disk.curvature.x * s.halfLength * s.halfLength + disk.curvature.y * s.halfWidth * s.halfWidth) -
           plane.slack;
}

/// Whether the gap may be below `below` [m] in the box, and not only on edges.
bool DiskClearance::canHold(double below, const Box& box, const Sides& s, const Attitude& attitude,
                            const DiskUnder& disk)
{
    if (boundOf({.recess = leastOf(box)}, s, attitude, disk) >= below) return false;
    if (isSmooth(s)) return boundOf(planeOf(s), s, attitude, disk) < below;
    if (std::min(box.levelX, box.levelY) >= edgeLevel && s.x - s.halfLength > recess_.taperLength()) {
        const Recess::Slopes form = recess_.formSlopes(s.x, s.y);
        const double changesX = disk.curvature.x * (s.halfLength + s.halfWidth),
                     changesY = disk.curvature.y * (s.halfLength + s.halfWidth);
        if (std::abs(form.x - attitude.pitch - disk.slopeX) > changesX ||
            std::abs(form.y - attitude.roll - disk.slopeY) > changesY)
            return false; // nowhere level
    }
    const bool tile = box.levelX == knownLevels && box.levelY == knownLevels;
    if (tile) return true;
    std::optional<double>& least = known(box, s).least;
    if (!least) least = leastRecess(s, 2);
    return boundOf({.recess = *least}, s, attitude, disk) < below;
}

DiskClearance::Known& DiskClearance::known(const Box& box, const Sides& s)
{
    static_assert(deepest < 32);
    constexpr std::size_t most = 1 << 16;
    if (known_.size() > most) known_.clear();
    const auto bits = [](int number) { return static_cast<std::uint64_t>(number); };
    const std::uint64_t key = ((bits(box.levelX) << 5 | bits(box.levelY)) << 21 | bits(box.i)) << 21 | bits(box.j);
    const auto [at, isNew] = known_.try_emplace(key);
    if (isNew) at->second.middle = recess_.at(s.x, s.y);
    return at->second;
}

/// Whether the gap changes more along the box than across it.
bool DiskClearance::halvesLength(const Box& box, const Sides& s, const Attitude& attitude, const DiskUnder& disk) const
{
    const Recess::Slopes form = recess_.formSlopes(s.x, s.y);
    const double along = (std::abs(form.x - attitude.pitch - disk.slopeX) + 0.5 * disk.curvature.x * s.halfLength) *
                         s.halfLength,
                 across = (std::abs(form.y - attitude.roll - disk.slopeY) + 0.5 * disk.curvature.y * s.halfWidth) *
                          s.halfWidth;
    // If both are equal, for example infinite, the longer side is halved.
    return along == across ? box.levelX <= box.levelY : along > across;
}

void DiskClearance::lookAlong(const MinimumSpacing::EdgePart& edge, int level, const Attitude& attitude, double time,
                              double tolerance, Found& least) const
{
    const SurfacePoint from = edge.from, to = edge.to, at{0.5 * (from.x + to.x), 0.5 * (from.y + to.y)};
    const double dx = to.x - from.x, dy = to.y - from.y, mean = 0.5 * (edge.recess + edge.recessTo);
    const double here = lift(attitude, at.x, at.y), below = least.gap - tolerance;
    const double tilt = 0.5 * (edge.recessTo - edge.recess - attitude.pitch * dx - attitude.roll * dy);
    const double lowest = mean + here - std::abs(tilt) - edge.slack;
    if (lowest - disk_.highest() >= below) return;
    const Sides sides{at.x, at.y, 0.5 * std::abs(dx), 0.5 * std::abs(dy)};
    if (lowest - highestUnder(sides, time) >= below) return;
    const DiskUnder disk = under(sides, time);
    const double recess = recess_.at(at.x, at.y);
    if (std::min(mean, recess) + here - disk.height - std::abs(tilt - 0.5 * (disk.slopeX * dx + disk.slopeY * dy)) -
            0.125 * (disk.curvature.x * dx * dx + disk.curvature.y * dy * dy) >=
        below)
        return;
    if (const double gap = recess + here - disk.height; gap < least.gap) least = {gap, at.x, at.y};
    if (level == deepestOfEdges) return;
    lookAlong({from, at, edge.recess, recess, edge.slack}, level + 1, attitude, time, tolerance, least);
    lookAlong({at, to, recess, edge.recessTo, edge.slack}, level + 1, attitude, time, tolerance, least);
}

/// All but those at which the gap is larger than at the place of the minimum spacing, wherever the disk is.
void DiskClearance::seekNearEdges(const Attitude& attitude, double spacing)
{
    constexpr double margin = 2e-9, slack = 1e-12; // of displacements; for rounding [m]
    if (edgesAt_ && displacement(*edgesAt_, attitude, recess_.length(), recess_.width()) <= margin) return;
    edgesAt_ = attitude;
    nearEdges_.clear();
    const double highest = spacing + disk_.highest() - disk_.lowest() + 2.0 * margin + slack;
    for (const MinimumSpacing::EdgePart& edge : spacing_.edges()) {
        const double ends = std::min(edge.recess + lift(attitude, edge.from.x, edge.from.y),
                                     edge.recessTo + lift(attitude, edge.to.x, edge.to.y));
        if (ends - edge.slack < highest) nearEdges_.push_back(edge);
    }
}

DiskClearance::Found DiskClearance::followed(Found from, const Attitude& attitude, double time) const
{
    const double length = recess_.length(), width = recess_.width();
    for (double step = firstStep; step >= lastStep;) {
        Found lowest = from;
        for (const auto& [right, up] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const Found here = gapAt(attitude, std::clamp(from.x + right * step * length, 0.0, length),
                                     std::clamp(from.y + up * step * width, 0.0, width), time);
            if (here.gap < lowest.gap) lowest = here;
        }
        if (lowest.gap < from.gap)
            from = lowest;
        else
            step *= 0.5;
    }
    return from;
}

DiskClearance::Place DiskClearance::at(const Attitude& attitude, double time)
{
    const MinimumSpacing::Place plane = spacing_.at(attitude);
    if (disk_.flat()) return {plane.spacing, plane.at, 0.0};
    Found least = gapAt(attitude, plane.at.x, plane.at.y, time);
    const auto look = [&](const Found& found) {
        if (found.gap < least.gap) least = found;
    };
    if (last_) { // where it was under the slider, and where it has moved with the disk
        const double passed = time - lastTime_;
        look(gapAt(attitude, last_->x, last_->y, time));
        look(gapAt(attitude, std::clamp(last_->x + velocity_.x * passed, 0.0, recess_.length()),
                   std::clamp(last_->y + velocity_.y * passed, 0.0, recess_.width()), time));
    }
    least = followed(least, attitude, time);
    const double tolerance = allowed * (disk_.highest() - disk_.lowest());
    seekNearEdges(attitude, plane.spacing);
    for (const MinimumSpacing::EdgePart& edge : nearEdges_) lookAlong(edge, 0, attitude, time, tolerance, least);
    heap_.assign(1, boxOf(0, 0, 0, 0, attitude, time));
    for (std::size_t count = 0; !heap_.empty() && count < mostBoxes; ++count) {
        std::pop_heap(heap_.begin(), heap_.end());
        const Box box = heap_.back();
        heap_.pop_back();
        if (box.bound >= least.gap - tolerance) break;
        const Sides sides = sidesOf(box);
        const DiskUnder disk = under(sides, time);
        const double middle = known(box, sides).middle;
        look({middle + lift(attitude, sides.x, sides.y) - disk.height, sides.x, sides.y});
        const bool small = box.levelX >= knownLevels;
        if (small && !canHold(least.gap - tolerance, box, sides, attitude, disk)) continue;
        const bool alongX = !small || halvesLength(box, sides, attitude, disk), alongY = !small || !alongX;
        if ((alongX ? box.levelX : box.levelY) == deepest) continue;
        for (int up = 0; up <= (alongY ? 1 : 0); ++up)
            for (int right = 0; right <= (alongX ? 1 : 0); ++right) {
                const Box child = boxOf(box.levelX + alongX, box.levelY + alongY, alongX ? 2 * box.i + right : box.i,
                                        alongY ? 2 * box.j + up : box.j, attitude, time);
                if (child.bound >= least.gap - tolerance) continue;
                heap_.push_back(child);
                std::push_heap(heap_.begin(), heap_.end());
            }
    }
    least = followed(least, attitude, time);
    last_ = SurfacePoint{least.x, least.y};
    lastTime_ = time;
    return {least.gap, {least.x, least.y}, diskHeight({least.x, least.y}, time)};
}

} // namespace touchdown
