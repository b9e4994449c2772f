// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far modes on one grid are from those on infinitely many cells, from the modes about the static states on grids of
// half and of a quarter as many cells along each axis.
//
// Cells change a mode through the waves that the disk drags along under a rail, through the stiffness of small pads and
// through the static attitude: partly of second order, partly by where lines meet edges, of either sign. The damping
// ratio is the small real part of a rate s, the frequency its imaginary part. Cells change the film's force in size and
// in phase, so they move s in any direction, and either part may agree by chance on two grids. Both parts seldom do, so
// the distance of whole rates counts. With d2 = |s - s2|/|s| from the finest grid to half of it, and d4 from that to a
// quarter, the error of first order is x = max(d2, d4/2), or 2 d2 without a quarter, with which d2 could be compared.
// Errors: F x of the damping ratio and of the frequency, relative to itself. F was chosen on sliders drawn at random,
// with modes of 80 kHz to 1.4 MHz; how often the errors hold on others is in tests/bench/README.md.
#pragma once

#include <complex>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/simulation/static_state/steady.h"

namespace touchdown {

/// The factors F [-].
inline constexpr double dampingErrorFactor = 0.5, frequencyErrorFactor = 1.5;

/// Rates s of the modes on a grid of about this share of the cells of `fine` along each axis, whose rates are `near`
/// [1/s]; empty where there is no static state on it, where a mode was lost, or where it would have too few cells.
std::vector<std::complex<double>> coarserRates(const Case& c, const SteadyResult& fine, double share,
                                               std::span<const std::complex<double>> near,
                                               const std::function<bool(const std::string& stage)>& goOn);

/// Sets the errors of modes with the rates `finest` from those on half and on a quarter of the cells; without the
/// latter from the former alone, without both not known.
void setErrors(std::vector<AirBearingMode>& modes, std::span<const std::complex<double>> finest,
               std::span<const std::complex<double>> half, std::span<const std::complex<double>> quarter);

} // namespace touchdown
