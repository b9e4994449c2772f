// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/disk_under_film.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace touchdown {

Velocity surfaceVelocity(const Case& c, const DiskTopography& surface)
{
    if (surface.flat() || c.diskSurface.motion != SurfaceMotion::Moving) return {};
    return diskVelocity(c.disk, c.slider.length, c.slider.width, 0.5 * c.slider.length, 0.5 * c.slider.width);
}

DiskUnderFilm::DiskUnderFilm(const Case& c, const DiskTopography& surface, const CellGrid& grid, const PaddedGrid& pad)
    : surface_(surface), grid_(grid), pad_(pad), velocity_(surfaceVelocity(c, surface)), means_(grid.cells(), 0.0)
{}

void DiskUnderFilm::at(double time, std::span<double> height)
{
    assert(height.size() == pad_.size());
    if (flat()) {
        std::ranges::fill(height, 0.0);
        return;
    }
    if (std::isnan(meansTime_) || (moves() && time != meansTime_)) {
        surface_.cellMeans(grid_, velocity_.x * time, velocity_.y * time, means_, work_);
        meansTime_ = time;
    }
    const auto nx = static_cast<std::size_t>(pad_.nx);
    for (int j = -PaddedGrid::rings; j < pad_.ny + PaddedGrid::rings; ++j) {
        const double* row = means_.data() + static_cast<std::size_t>(std::clamp(j, 0, pad_.ny - 1)) * nx;
        double* to = height.data() + pad_.at(0, j);
        std::copy(row, row + nx, to);
        for (int ring = 1; ring <= PaddedGrid::rings; ++ring) {
            to[-ring] = row[0];
            to[pad_.nx - 1 + ring] = row[nx - 1];
        }
    }
}

} // namespace touchdown
