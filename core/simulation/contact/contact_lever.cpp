// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/contact_lever.h"

#include <cmath>

#include "core/case/contact_law.h"

namespace touchdown {

CoulombFriction frictionOf(const Case& c)
{
    const auto friction = contactLaw(c).friction;
    return {.coefficient = friction ? friction(c) : 0.0, .arm = 0.5 * c.slider.thickness};
}

ContactLever::ContactLever(const Case& c)
    : length_(c.slider.length), width_(c.slider.width), disk_(c.disk), friction_(frictionOf(c))
{}

ContactLever::Rubbing ContactLever::rubbing(double x, double y) const
{
    const Velocity disk = diskVelocity(disk_, length_, width_, x, y);
    const double sliding = std::hypot(disk.x, disk.y);
    if (!(sliding > 0.0)) return {};
    const double force = friction_.force(1.0, sliding);
    const double moment = friction_.pitchMoment(1.0, sliding);
    return {force, moment * disk.x / sliding, moment * disk.y / sliding};
}

} // namespace touchdown
