// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/sample_extremes.h"

#include <algorithm>
#include <utility>

namespace touchdown {

namespace {

constexpr double nearestShare = 0.02; // of the time between the outer two of three points [-]

} // namespace

void SampleExtremes::add(double time, std::span<const double> values, bool smooth)
{
    if (!smooth) smoothPoints_ = 0;
    for (std::size_t i = 0; i < quantities_; ++i) {
        least_[i] = std::min(least_[i], values[i]);
        most_[i] = std::max(most_[i], values[i]);
    }
    const double h0 = last_.time - before_.time, h1 = time - last_.time; // [s]
    if (smoothPoints_ == 2 && std::min(h0, h1) > nearestShare * (h0 + h1)) {
        for (std::size_t i = 0; i < quantities_; ++i) {
            const double middle = last_.values[i];
            const double rise = (middle - before_.values[i]) / h0, next = (values[i] - middle) / h1;
            const double curvature = (next - rise) / (h0 + h1);
            // Else the middle point is not the extreme of the three.
            if (!(rise * next <= 0.0) || curvature == 0.0) continue;
            const double slope = rise + curvature * h0; // at the middle point
            double vertex = middle - slope * slope / (4.0 * curvature);
            // What keeps its sign at the points keeps it between them, as a force does where contact begins.
            const auto [low, high] = std::minmax({before_.values[i], middle, values[i]});
            if (low >= 0.0) vertex = std::max(vertex, 0.0);
            if (high <= 0.0) vertex = std::min(vertex, 0.0);
            least_[i] = std::min(least_[i], vertex);
            most_[i] = std::max(most_[i], vertex);
        }
    }
    std::swap(before_, last_);
    last_.time = time;
    last_.values.assign(values.begin(), values.end());
    smoothPoints_ = std::min<std::size_t>(2, smoothPoints_ + 1);
}

void SampleExtremes::restart()
{
    clear();
    for (std::size_t i = 0; i < last_.values.size(); ++i) least_[i] = most_[i] = last_.values[i];
}

void SampleExtremes::clear()
{
    least_.assign(quantities_, std::numeric_limits<double>::infinity());
    most_.assign(quantities_, -std::numeric_limits<double>::infinity());
}

} // namespace touchdown
