// SPDX-License-Identifier: GPL-3.0-or-later
//
// Upper bound of the rates at which the air under a slider at a fixed attitude relaxes: no eigenvalue of V^-1 J, J =
// dR/dp, is larger than
//
//   max_i (sum_k |J_ik|)/V_i        (Gershgorin 1931)
//
// over the cells i. The fastest diffusion, with opposite signs in neighbouring cells, comes close to it. An explicit
// step dp = -dt V^-1 R is stable up to dt = 2/rate; implicit steps have no such limit. Only the flows along the paths
// count: the corrections of the complete flux scheme, which its limiter removes from fast disturbances, do not.
#pragma once

namespace touchdown {

class GasFilm;

/// At the film's last linearisation [1/s]. Cells whose gap is closed store nothing and do not count.
double fastestFilmRate(const GasFilm& film);

} // namespace touchdown
