// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/law_switch.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/contact/slider_contact.h"

namespace touchdown {

std::optional<double> wayToSwitch(const SliderContact& contact, const SliderBody& body, const FilmPoint& begin,
                                  const FilmPoint& end, double width, double shortest)
{
    const Interval holds = contact.interval();
    if (!std::isfinite(holds.lower) && !std::isfinite(holds.upper)) return std::nullopt;
    const double dt = end.dt;
    const auto beyond = [&](double share) {
        const double d = contact.separation(body.attitude(between(begin, end, share).q));
        return std::max(d - holds.upper, holds.lower - d);
    };
    // Further from a switch than the way bends from a straight line there is none.
    const double bend = std::max(body.displacement(begin.motion.a), body.displacement(end.motion.a));
    if (std::max(beyond(0.0), beyond(1.0)) < -bend * dt * dt) return std::nullopt;
    constexpr int looks = 8; // within a step, so that a short visit is not missed
    double inside = 0.0;
    for (int k = 1; k <= looks; ++k) {
        double outside = double(k) / looks;
        if (!(beyond(outside) > 0.0)) {
            inside = outside;
            continue;
        }
        // Just crossed: a distance of the size of rounding is no way back.
        if (k == looks && beyond(outside) <= width) return dt;
        const double past = std::min(beyond(outside), 0.5 * width);
        for (int n = 0; n < 60; ++n) {
            const double middle = 0.5 * (inside + outside);
            (beyond(middle) >= past ? outside : inside) = middle;
        }
        return std::min(dt, std::max(outside * dt, shortest));
    }
    return std::nullopt;
}

SwitchAim aimAtSwitch(const SliderContact& contact, const SliderBody& body, const SliderMotion& begin,
                      const SliderMotion& tried, double dt, double width)
{
    const Interval holds = contact.interval();
    const double d = contact.separation(body.attitude(tried.q)), before = contact.separation(body.attitude(begin.q));
    SwitchAim aim;
    aim.upper = std::abs(d - holds.upper) < std::abs(d - holds.lower);
    aim.miss = d - (aim.upper ? holds.upper + 0.5 * width : holds.lower - 0.5 * width);
    aim.reached = aim.upper ? d >= holds.upper : d <= holds.lower;
    // The rate, along the way from the step's beginning where it has no other sense.
    const double ahead = 1e-3 * dt;
    const double there = contact.separation(body.attitude(tried.q + ahead * (tried.v + 0.5 * ahead * tried.a)));
    aim.rate = (there - d) / ahead;
    if (!(aim.rate * (aim.upper ? 1.0 : -1.0) > 0.0)) aim.rate = (d - before) / dt;
    return aim;
}

} // namespace touchdown
