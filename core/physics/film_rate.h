// SPDX-License-Identifier: GPL-3.0-or-later
//
// How fast the fastest part of a film at a fixed attitude evens out: the largest eigenvalue of V^-1 J, J = dR/dp. An explicit step
// dp = -dt V^-1 R is stable up to dt = 2/rate; with implicit steps no rate limits anything.
#pragma once

#include "core/physics/gas_film.h"

namespace touchdown {

/// [1/s]; of the film's last linearisation, by power iteration, from below to about a hundredth. Cells whose gap is closed store
/// nothing and do not count.
double fastestFilmRate(const GasFilm& film);

} // namespace touchdown
