// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/disk_passage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/physics/disk/disk_surface_check.h"
#include "core/physics/disk/disk_topography.h"

namespace touchdown {

namespace {

/// The time in which a length passes at this speed [s].
double passing(double length, double speed)
{
    return speed != 0.0 ? length / std::abs(speed) : std::numeric_limits<double>::infinity();
}

/// The time in which half a cell of a map passes, of these sides [s].
double cellPassage(double dx, double dy, const Velocity& velocity)
{
    return std::min(passing(0.5 * dx, velocity.x), passing(0.5 * dy, velocity.y));
}

} // namespace

double finestPassage(const DiskSurface& surface, const Velocity& velocity)
{
    double finest = std::numeric_limits<double>::infinity();
    const auto consider = [&](double time) { finest = std::min(finest, time); };
    if (hasWaves(surface))
        for (std::size_t i = 0; i < surface.waveLengths.size(); ++i) {
            const double angle = surface.waveAngles.empty() ? 0.0 : surface.waveAngles[i];
            const double speed = velocity.x * std::cos(angle) + velocity.y * std::sin(angle);
            consider(passing(surface.waveLengths[i] / passageParts, speed));
        }
    if (hasRoughness(surface)) consider(cellPassage(surface.cell, surface.cell, velocity));
    if (hasBumps(surface))
        for (std::size_t i = 0; i < surface.bumpLengths.size(); ++i) {
            const double width = surface.bumpWidths.empty() ? surface.bumpLengths[i] : surface.bumpWidths[i];
            consider(passing(surface.bumpLengths[i] / passageParts, velocity.x));
            consider(passing(width / passageParts, velocity.y));
        }
    return finest;
}

double finestPassage(const DiskSurface& surface, const DiskTopography& topography, const Velocity& velocity)
{
    const double finest = finestPassage(surface, velocity);
    if (!hasFile(surface)) return finest;
    const UniformGrid map = topography.period(); // of the finest map; the same across where it is a profile
    return std::min(finest, cellPassage(map.dx, map.dy, {velocity.x, map.ny > 1 ? velocity.y : 0.0}));
}

} // namespace touchdown
