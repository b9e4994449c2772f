// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/disk_clearance.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

namespace {

constexpr int knownLevels = 7;               // the recess is sampled in 128 x 128 tiles
constexpr int deepest = 11;                  // level of the smallest boxes
constexpr int samples = 16;                  // of a tile that edges cross, along each side
constexpr double curvature = 1e-12;          // of the form within a smooth tile, at most [m]
constexpr double allowed = 1.0 / 1000.0;     // of the disk's range of heights
constexpr std::size_t mostBoxes = 200000;    // looked at; beyond, the least gap found so far counts
constexpr double firstStep = 0x1p-11;        // of the search downhill, of the slider's sides
constexpr double lastStep = firstStep / 512; // and where it ends

} // namespace

DiskClearance::DiskClearance(const Recess& recess, const MinimumSpacing& spacing, const DiskTopography& disk,
                             const Velocity& velocity)
    : recess_(recess), spacing_(spacing), disk_(disk), velocity_(velocity)
{
    if (disk_.flat()) return;
    for (int level = 0; level <= knownLevels; ++level) least_.emplace_back(std::size_t{1} << (2 * level), 0.0F);
    const int tiles = 1 << knownLevels;
    const double length = recess_.length() / tiles, width = recess_.width() / tiles;
    const auto leastOf = [&](int i, int j) {
        const double x = i * length, y = j * width;
        const bool smooth = recess_.isSmooth(x, x + length, y, y + width);
        const int count = smooth ? 2 : samples;
        double least = recess_.at(x, y);
        for (int m = 0; m < count; ++m)
            for (int k = 0; k < count; ++k)
                least = std::min(least, recess_.at(x + length * k / (count - 1), y + width * m / (count - 1)));
        return static_cast<float>(least - curvature);
    };
    for (int j = 0; j < tiles; ++j)
        for (int i = 0; i < tiles; ++i) least_.back()[static_cast<std::size_t>(j * tiles + i)] = leastOf(i, j);
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

double DiskClearance::lift(const Attitude& a, double x, double y) const
{
    return a.height + a.pitch * (recess_.length() - x) - a.roll * (y - 0.5 * recess_.width());
}

DiskClearance::Found DiskClearance::gapAt(const Attitude& attitude, double x, double y, double time) const
{
    return {recess_.at(x, y) + lift(attitude, x, y) - diskHeight({x, y}, time), x, y};
}

DiskClearance::Box DiskClearance::boxOf(int level, int i, int j, const Attitude& attitude, double time) const
{
    const int boxes = 1 << level, known = std::min(level, knownLevels), finer = level - known;
    const double x0 = recess_.length() * i / boxes, x1 = recess_.length() * (i + 1) / boxes;
    const double y0 = recess_.width() * j / boxes, y1 = recess_.width() * (j + 1) / boxes;
    const double least =
        least_[static_cast<std::size_t>(known)][static_cast<std::size_t>((j >> finer) * (1 << known) + (i >> finer))];
    const double shiftX = velocity_.x * time, shiftY = velocity_.y * time;
    return {least + lift(attitude, attitude.pitch > 0.0 ? x1 : x0, attitude.roll > 0.0 ? y1 : y0) -
                disk_.upperBound(x0 - shiftX, x1 - shiftX, y0 - shiftY, y1 - shiftY),
            level, i, j};
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
        look(followed(gapAt(attitude, last_->x, last_->y, time), attitude, time));
        const double passed = time - lastTime_, x = last_->x + velocity_.x * passed,
                     y = last_->y + velocity_.y * passed;
        if (x >= 0.0 && x <= recess_.length() && y >= 0.0 && y <= recess_.width())
            look(followed(gapAt(attitude, x, y, time), attitude, time));
    }
    const double tolerance = allowed * (disk_.highest() - disk_.lowest());
    const double tilt = std::abs(attitude.pitch) * recess_.length() + std::abs(attitude.roll) * recess_.width(); // [m]
    heap_.assign(1, boxOf(0, 0, 0, attitude, time));
    for (std::size_t count = 0; !heap_.empty() && count < mostBoxes; ++count) {
        std::pop_heap(heap_.begin(), heap_.end());
        const Box box = heap_.back();
        heap_.pop_back();
        if (box.bound >= least.gap - tolerance) break;
        const int boxes = 1 << box.level;
        const Found middle =
            gapAt(attitude, recess_.length() * (box.i + 0.5) / boxes, recess_.width() * (box.j + 0.5) / boxes, time);
        look(middle);
        if (box.level == deepest) {
            // At the corner of a rail the gap is less than in the middle of the box by the tilt.
            if (middle.gap - tilt / boxes < least.gap - tolerance) look(followed(middle, attitude, time));
            continue;
        }
        for (const int up : {0, 1})
            for (const int right : {0, 1}) {
                const Box child = boxOf(box.level + 1, 2 * box.i + right, 2 * box.j + up, attitude, time);
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
