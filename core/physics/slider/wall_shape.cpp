// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/wall_shape.h"

#include <algorithm>

namespace touchdown {

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

} // namespace touchdown
