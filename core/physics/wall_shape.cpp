// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/wall_shape.h"

#include <algorithm>

namespace touchdown {

WallShape::WallShape(const WallProfile& profile)
    : distance_(profile.distance), recess_(profile.recess), lowest_(profile.recess)
{
    for (std::size_t i = lowest_.size() - 1; i > 0; --i) lowest_[i - 1] = std::min(lowest_[i - 1], lowest_[i]);
    maximum_ = *std::max_element(recess_.begin(), recess_.end());
}

double WallShape::at(double distance) const
{
    std::size_t i = 1; // the first point beyond
    while (i < distance_.size() && distance_[i] <= distance) ++i;
    if (i == distance_.size()) return recess_.back();
    const double part = (distance - distance_[i - 1]) / (distance_[i] - distance_[i - 1]);
    return recess_[i - 1] + part * (recess_[i] - recess_[i - 1]);
}

double WallShape::minimumFrom(double distance) const
{
    if (distance <= inner()) return lowest_.front();
    if (distance >= outer()) return lowest_.back();
    const auto beyond = std::upper_bound(distance_.begin(), distance_.end(), distance) - distance_.begin();
    return std::min(at(distance), lowest_[static_cast<std::size_t>(beyond)]);
}

} // namespace touchdown
