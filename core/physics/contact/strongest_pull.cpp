// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/strongest_pull.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace touchdown {

PullPoint strongestPull(const TracedContact& contact, double from, double to, double resolution)
{
    assert(resolution > 0.0);
    constexpr double golden = 0.6180339887498949;
    const auto at = [&](double separation) {
        contact.recall();
        return PullPoint{separation, contact.force(separation)};
    };
    double low = std::min(from, to), high = std::max(from, to);
    PullPoint a = at(high - golden * (high - low)), b = at(low + golden * (high - low));
    while (high - low > resolution && a.separation < b.separation) {
        if (a.force < b.force) {
            high = b.separation;
            b = a;
            a = at(high - golden * (high - low));
        } else {
            low = a.separation;
            a = b;
            b = at(low + golden * (high - low));
        }
    }
    return a.force < b.force ? a : b;
}

} // namespace touchdown
