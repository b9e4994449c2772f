// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/disk_clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace touchdown {

namespace {

constexpr std::size_t mostSampled = 32768;         // points of all tiles, where fewer points of each reach so few
constexpr std::array<int, 4> strides{1, 3, 5, 15}; // over the samples of a tile; all meet its corners
constexpr std::size_t mostFollowed = 6;            // of the lowest samples, each of another tile
constexpr double finestStep = 1.0 / 256.0;         // of the distance between samples
constexpr double curvature = 1e-12;                // of the form within a smooth tile, at most [m]

} // namespace

DiskClearance::DiskClearance(const Recess& recess, const MinimumSpacing& spacing, const DiskTopography& disk,
                             const Velocity& velocity)
    : recess_(recess),
      spacing_(spacing),
      disk_(disk),
      velocity_(velocity),
      tileLength_(recess.length() / tiles),
      tileWidth_(recess.width() / tiles)
{
    if (disk_.flat()) return;
    least_.assign(tiles * tiles, 0.0F);
    recessSamples_.resize(least_.size());
    for (int j = 0; j < tiles; ++j)
        for (int i = 0; i < tiles; ++i) {
            const double x0 = i * tileLength_, x1 = x0 + tileLength_, y0 = j * tileWidth_, y1 = y0 + tileWidth_;
            float& least = least_[static_cast<std::size_t>(j * tiles + i)];
            if (recess_.isSmooth(x0, x1, y0, y1)) {
                least = static_cast<float>(
                    std::min({recess_.at(x0, y0), recess_.at(x1, y0), recess_.at(x0, y1), recess_.at(x1, y1)}) -
                    curvature);
            } else {
                const std::vector<float>& all = recessOf(j * tiles + i);
                least = *std::ranges::min_element(all);
            }
        }
}

double DiskClearance::lift(const Attitude& a, double x, double y) const
{
    return a.height + a.pitch * (recess_.length() - x) - a.roll * (y - 0.5 * recess_.width());
}

double DiskClearance::gapAt(const Attitude& attitude, double x, double y, double time) const
{
    return recess_.at(x, y) + lift(attitude, x, y) - diskHeight({x, y}, time);
}

/// A lower bound of the gap to the highest point of the disk.
double DiskClearance::bound(const Attitude& attitude, int tile) const
{
    const double x = tileLength_ * (tile % tiles + (attitude.pitch > 0.0 ? 1 : 0));
    const double y = tileWidth_ * (tile / tiles + (attitude.roll > 0.0 ? 1 : 0));
    return least_[static_cast<std::size_t>(tile)] + lift(attitude, x, y) - disk_.highest();
}

const std::vector<float>& DiskClearance::recessOf(int tile)
{
    std::vector<float>& all = recessSamples_[static_cast<std::size_t>(tile)];
    if (all.empty())
        for (int m = 0; m < samples; ++m)
            for (int k = 0; k < samples; ++k)
                all.push_back(static_cast<float>(recess_.at(tileLength_ * (tile % tiles + k / (samples - 1.0)),
                                                            tileWidth_ * (tile / tiles + m / (samples - 1.0)))));
    return all;
}

DiskClearance::Found DiskClearance::followed(Found from, double step, const Attitude& attitude, double time) const
{
    const double length = recess_.length(), width = recess_.width();
    const double dx = tileLength_ / (samples - 1), dy = tileWidth_ / (samples - 1);
    while (step >= finestStep) {
        Found lowest = from;
        for (const auto& [right, up] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const double x = std::clamp(from.x + right * step * dx, 0.0, length),
                         y = std::clamp(from.y + up * step * dy, 0.0, width);
            if (const double gap = gapAt(attitude, x, y, time); gap < lowest.gap) lowest = {gap, x, y};
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
    Found least{plane.spacing - diskHeight(plane.at, time), plane.at.x, plane.at.y};
    open_.clear();
    for (int tile = 0; tile < tiles * tiles; ++tile)
        if (bound(attitude, tile) < least.gap) open_.push_back(tile);
    int stride = strides.front();
    for (const int each : strides) {
        const auto along = static_cast<std::size_t>((samples - 1) / (stride = each) + 1);
        if (open_.size() * along * along <= mostSampled) break;
    }

    // The lowest sample of each of the lowest tiles, ascending.
    std::array<Found, mostFollowed> lowest{};
    std::size_t count = 0;
    for (const int tile : open_) {
        if (bound(attitude, tile) >= least.gap) continue;
        const std::vector<float>& recess = recessOf(tile);
        Found here{std::numeric_limits<double>::infinity(), 0.0, 0.0};
        for (int m = 0; m < samples; m += stride)
            for (int k = 0; k < samples; k += stride) {
                const double x = tileLength_ * (tile % tiles + k / (samples - 1.0)),
                             y = tileWidth_ * (tile / tiles + m / (samples - 1.0));
                const double above = recess[static_cast<std::size_t>(m * samples + k)] + lift(attitude, x, y);
                if (above - disk_.highest() >= here.gap) continue;
                if (const double gap = above - diskHeight({x, y}, time); gap < here.gap) here = {gap, x, y};
            }
        if (here.gap < least.gap) least = here;
        if (std::isinf(here.gap)) continue;
        const auto place = std::ranges::find_if(lowest.begin(), lowest.begin() + static_cast<std::ptrdiff_t>(count),
                                                [&](const Found& each) { return here.gap < each.gap; });
        if (count < mostFollowed) ++count;
        if (place == lowest.begin() + static_cast<std::ptrdiff_t>(count)) continue;
        std::move_backward(place, lowest.begin() + static_cast<std::ptrdiff_t>(count) - 1,
                           lowest.begin() + static_cast<std::ptrdiff_t>(count));
        *place = here;
    }
    const double step = 0.5 * stride; // of the distance between samples
    least = followed(least, step, attitude, time);
    for (std::size_t k = 0; k < count; ++k)
        if (const Found found = followed(lowest[k], step, attitude, time); found.gap < least.gap) least = found;
    return {least.gap, {least.x, least.y}, diskHeight({least.x, least.y}, time)};
}

} // namespace touchdown
