// SPDX-License-Identifier: GPL-3.0-or-later
//
// Free oscillations of a slider in one of its modes.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/case/case.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown::test {

/// s of exp(s t) [1/s].
inline std::complex<double> rateOf(const AirBearingMode& mode)
{
    const double omega = 2.0 * std::numbers::pi * mode.frequency;
    return {-mode.dampingRatio * omega / std::sqrt(1.0 - mode.dampingRatio * mode.dampingRatio), omega};
}

/// The slider displaced from its static state and kicked as the mode moves; its air is that of the displaced slider at
/// rest, which fades within the first periods. `amplitude`: of the corner that moves most [m].
inline Case released(Case c, const AirBearingMode& mode, double amplitude)
{
    const std::complex<double> s = rateOf(mode);
    std::array<std::complex<double>, 3> shape;
    for (std::size_t k = 0; k < 3; ++k) shape[k] = {amplitude * mode.shape[k][0], amplitude * mode.shape[k][1]};
    c.initial.state = InitialState::Static;
    c.initial.heightOffset = shape[0].real();
    c.initial.pitchOffset = shape[1].real();
    c.initial.rollOffset = shape[2].real();
    c.initial.verticalVelocity = (s * shape[0]).real();
    c.initial.pitchVelocity = (s * shape[1]).real();
    c.initial.rollVelocity = (s * shape[2]).real();
    return c;
}

} // namespace touchdown::test
