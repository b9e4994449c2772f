// SPDX-License-Identifier: GPL-3.0-or-later
//
// Upper bound of the relaxation rates of the air under a slider at a fixed attitude: no eigenvalue of V^-1 J, J =
// dR/dp, is larger than
//
//   max_i (sum_k |J_ik|)/V_i        (Gershgorin 1931)
//
// over the cells i. The fastest diffusion, with opposite signs in neighbouring cells, is close to it. An explicit step
// dp = -dt V^-1 R is stable up to dt = 2/rate. Only the flows along the paths count: the limiter removes the
// corrections of the complete flux scheme from fast disturbances.
#pragma once

namespace touchdown {

class GasFilm;

/// At the film's last linearisation [1/s]. Cells whose gap is closed store nothing and do not count.
double fastestFilmRate(const GasFilm& film);

} // namespace touchdown
