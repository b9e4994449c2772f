// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a slider moves in one of its modes. A mode is q e^(st) with complex amplitudes q of the mass centre's height, the
// pitch and the roll; here without its decay, and with 1 m as the largest motion of a corner, as the core scales it.
//
//   u(x, y) = q_height + q_pitch (L/2 - x) - q_roll (y - W/2)
#pragma once

#include <complex>
#include <optional>

#include <QString>

#include "core/simulation/static_state/steady.h"

namespace touchdown {

/// Amplitude of a point of the slider [m].
std::complex<double> motionAt(const AirBearingMode& mode, const SliderCase& slider, double x, double y);

/// Change of the attitude at a phase [rad] of the cycle.
Attitude changeAt(const AirBearingMode& mode, const SliderCase& slider, double phase);

/// Where on the line along the middle of the slider, or beyond its ends, the motion is least: about a line across that
/// place the slider turns.
struct LeastMotion {
    double at = 0.0;     // x, or y of a roll [m]
    double motion = 0.0; // amplitude there [m]: more than 0 where height and angle are out of phase
};
/// Of a roll the place y on the line x = L/2, else the place x on y = W/2. Nothing where the slider moves without
/// turning: the place lies more than ten lengths of the slider away.
std::optional<LeastMotion> leastMotion(const AirBearingMode& mode, const SliderCase& slider);

/// "turns about x = 0.31 mm", "turns about x = 1.20 mm, behind the slider", "moves up and down as a whole".
QString motionWords(const AirBearingMode& mode, const SliderCase& slider);

/// "Vertical", "Pitch", "Roll".
QString kindWord(const AirBearingMode& mode);

} // namespace touchdown
