// SPDX-License-Identifier: GPL-3.0-or-later
//
// How fast the air under a slider at a fixed attitude evens out at most: no eigenvalue of V^-1 J, J = dR/dp, is larger
// than
//
//   max_i (sum_k |J_ik|)/V_i        (Gershgorin 1931)
//
// over the cells i, which the fastest diffusion, of neighbours up and down by turns, comes close to. An explicit step
// dp = -dt V^-1 R is stable up to dt = 2/rate; no rate limits implicit ones. Of the flows along their paths: what the
// complete flux scheme adds for the flow across them, which its limiter takes away from fast disturbances, is left out.
#pragma once

#include "core/physics/film/gas_film.h"

namespace touchdown {

/// [1/s]; of the film's last linearisation. Cells whose gap is closed store nothing and do not count.
double fastestFilmRate(const GasFilm& film);

} // namespace touchdown
