// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/springs/disk_under_springs.h"

#include <algorithm>
#include <cmath>

#include "core/case/disk_setup.h"
#include "core/physics/disk/disk_passage.h"
#include "core/physics/disk/disk_surface_check.h"
#include "core/simulation/contact/disk_under_film.h"

namespace touchdown {

DiskUnderSprings::DiskUnderSprings(const Case& c)
    : surface_(diskTopography(c)),
      velocity_(surfaceVelocity(c, surface_)),
      longestStep_(finestPassage(c.diskSurface, surface_, velocity_))
{
    const double middle = 0.5 * c.slider.length, across = 0.5 * c.slider.width;
    place_[SpringModel::Pad] = {middle + c.springs.padDistance, across};
    place_[SpringModel::Front] = {middle - c.springs.frontDistance, across};
    place_[SpringModel::Rear] = {middle + c.springs.rearDistance, across};
    recurrence_ = surfaceRecurrence(c.diskSurface, surface_, velocity_, {across, across, c.slider.length});
    for (std::size_t i = 0; i < place_.size(); ++i) // no slopes, which may be infinite
        still_.height[static_cast<Eigen::Index>(i)] = surface_.height(place_[i].x(), place_[i].y());
}

double DiskUnderSprings::passage() const
{
    if (!moves()) return 0.0;
    double furthest = 0.0; // [m]
    for (const Eigen::Vector2d& place : place_) furthest = std::max(furthest, place.norm());
    return furthest / std::hypot(velocity_.x, velocity_.y);
}

SpringModel::Under DiskUnderSprings::moved(double time) const
{
    SpringModel::Under under;
    for (std::size_t i = 0; i < place_.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        const DiskPoint at = surface_.point(place_[i].x() - velocity_.x * time, place_[i].y() - velocity_.y * time);
        under.height[k] = at.height;
        under.rate[k] = -(velocity_.x * at.slopeX + velocity_.y * at.slopeY);
    }
    return under;
}

} // namespace touchdown
