// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/bouncing_slider.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

double CycleEnergies::largest() const
{
    return std::max({std::abs(air), std::abs(suspension), std::abs(contact), std::abs(friction)});
}

void SwingOf::add(double value)
{
    least = std::min(least, value);
    most = std::max(most, value);
}

double Return::repeats(const Eigen::VectorXd& from) const
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t part = 1; part < passed.size(); ++part)
        if (passed.size() % part == 0) nearest = std::min(nearest, (passed[part - 1] - from).norm());
    return nearest;
}

} // namespace touchdown
