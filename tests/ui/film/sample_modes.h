// SPDX-License-Identifier: GPL-3.0-or-later
//
// Modes of the sample slider as formulas: a roll at 100 kHz and a pitch at 200 kHz about x = 0.75 L.
#pragma once

#include "tests/ui/sample_slider.h"

namespace touchdown {

inline ModesResult sampleModes(const Case& c)
{
    ModesResult result;
    result.steady = sampleResult(c);
    result.status = SteadyStatus::Converged;
    AirBearingMode roll;
    roll.frequency = 100e3;
    roll.dampingRatio = 0.05;
    roll.dampingError = 0.003;
    roll.kind = "roll";
    roll.shape[2] = {2.0 / c.slider.width, 0.0}; // 1 at the inner edge
    AirBearingMode pitch;
    pitch.frequency = 200e3;
    pitch.dampingRatio = 0.0123;
    pitch.kind = "pitch";
    // u = q (L/2 - x) + h is zero at x = 0.75 L for h = q L/4, and 1 at x = 0 for q = 4/(3 L).
    const double angle = 4.0 / (3.0 * c.slider.length);
    pitch.shape[0] = {0.25 * angle * c.slider.length, 0.0};
    pitch.shape[1] = {angle, 0.0};
    result.modes = {roll, pitch};
    return result;
}

} // namespace touchdown
