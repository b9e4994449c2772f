// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs there and back, and equilibria, as a hysteresis study has them.
#pragma once

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "core/studies/hysteresis/hysteresis_result.h"

namespace touchdown::test {

inline HeldStep step(double value, bool back, EndKind kind, double spacing)
{
    HeldStep held;
    held.value = value;
    held.back = back;
    held.done = true;
    const Motion motion = kind == EndKind::Intermittent ? Motion::Bounces : Motion::AtRest;
    held.end = {kind, spacing, 0.0, motion};
    held.spacing = {.mean = spacing, .std = 0.0, .min = spacing, .max = spacing};
    return held;
}

inline void letBounce(HeldStep& held)
{
    held.end.kind = EndKind::Intermittent;
    held.end.motion = Motion::Bounces;
}

/// f_m from 0 to 3 mN and back: touches at 2 mN, lets go at 0.
inline std::vector<HeldStep> loop()
{
    using enum EndKind;
    return {step(0.0, false, Flying, 7e-9),   step(1e-3, false, Flying, 7e-9), step(2e-3, false, Contact, 3e-9),
            step(3e-3, false, Contact, 2e-9), step(3e-3, true, Contact, 2e-9), step(2e-3, true, Contact, 3e-9),
            step(1e-3, true, Contact, 4e-9),  step(0.0, true, Flying, 7e-9)};
}

inline HeldSteps task()
{
    HeldSteps steps;
    steps.parameter = std::get<Parameter>(numberKey(steps.start, "ono_yamane.meniscus_force"));
    steps.values = {0.0, 1e-3, 2e-3, 3e-3};
    return steps;
}

inline StudiedEquilibrium at(double value, double spacing, Stability stability, double growth)
{
    return {value, spacing, 90e-6, stability, {{growth, 6.283185307179586e5}, {growth, -6.283185307179586e5}},
            0,     false};
}

inline bool says(const std::vector<std::string>& findings, const std::string& part)
{
    return std::ranges::any_of(findings, [&](const std::string& each) { return each.find(part) != std::string::npos; });
}

} // namespace touchdown::test
