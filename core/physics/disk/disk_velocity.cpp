// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/disk_velocity.h"

#include <cmath>

namespace touchdown {

/// With the angles of the header taken apart, size cos psi = omega (a cos phi + b sin phi) = omega (R cos phi - Y) and
/// -size sin psi = omega (b cos phi - a sin phi) = omega (X - R sin phi): omega x r of a rigid disk.
Velocity diskVelocity(const DiskMotion& disk, double length, double width, double x, double y)
{
    const bool rotating = disk.field == VelocityField::Rotating;
    const double fromCentreX = rotating ? 0.5 * length - x : 0.0; // X
    const double fromCentreY = rotating ? 0.5 * width - y : 0.0;  // Y
    return {disk.speed * (disk.radius * std::cos(disk.skew) - fromCentreY),
            disk.speed * (fromCentreX - disk.radius * std::sin(disk.skew))};
}

} // namespace touchdown
