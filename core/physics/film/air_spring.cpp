// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/air_spring.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

double AirSpring::potential(double z, PotentialBelowCutoff below) const
{
    if (stiffness == 0.0) return 0.0;
    const double ratio = staticSpacing / (below == PotentialBelowCutoff::Held ? std::max(z, cutoff) : z);
    return stiffness * staticSpacing * staticSpacing * (ratio - std::log(std::abs(ratio)) - 1.0);
}

} // namespace touchdown
