// SPDX-License-Identifier: GPL-3.0-or-later
//
// Velocity of the disk under the slider. With X = L/2 - x, Y = W/2 - y, a = R - Y cos phi - X sin phi, b = X cos phi -
// Y sin phi: size omega sqrt(a^2 + b^2), local skew psi = phi - atan(b/a), (U, V) = size (cos psi, -sin psi).
#pragma once

#include <cmath>
#include <cstdint>

namespace touchdown {

enum class VelocityField : std::uint8_t {
    Rotating, // as above: varies over the slider by a few per cent and about two degrees
    Uniform,  // the value at the slider's centre everywhere
};

struct Velocity {
    double x = 0.0; // towards the trailing edge [m/s]
    double y = 0.0; // towards the outer edge [m/s]
};

struct DiskMotion {
    double speed = 565.4866776461628; // omega [rad/s]: 5400 rpm
    double radius = 23e-3;            // R, of the slider's centre [m]
    double skew = 0.0; // phi [rad]; positive: air flows from the outer leading to the inner trailing edge
    VelocityField field = VelocityField::Rotating;
    bool operator==(const DiskMotion&) const = default;
};

/// The disk's velocity under the point (x, y) of a slider of this length and width [m].
inline Velocity diskVelocity(const DiskMotion& disk, double length, double width, double x, double y)
{
    // With the angles of the header expanded, size cos psi = omega (R cos phi - Y) and -size sin psi = omega (X - R sin
    // phi): omega x r of a rigid disk.
    const bool rotating = disk.field == VelocityField::Rotating;
    const double fromCentreX = rotating ? 0.5 * length - x : 0.0; // X
    const double fromCentreY = rotating ? 0.5 * width - y : 0.0;  // Y
    return {disk.speed * (disk.radius * std::cos(disk.skew) - fromCentreY),
            disk.speed * (fromCentreX - disk.radius * std::sin(disk.skew))};
}

} // namespace touchdown
