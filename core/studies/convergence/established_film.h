// SPDX-License-Identifier: GPL-3.0-or-later
//
// The static state of a film as the established program discretises it (core/studies/convergence/node_film.h), on
// uniform grids, as a method of the study of films over their grids. It states no error.
//
// The film at a fixed attitude is solved from ambient pressure, without coarser grids. In flight Broyden's method
// (1965) finds the attitude a at which load and torques G of the film balance the suspension,
//
//   a <- a + K^-1 G,   K <- K - (dG + K da) da^T/(da . da),
//
// from the state and the stiffness matrix K that our own film has on a coarse grid. The air's shear is taken from that
// film and kept: its torques change by less than the scheme's error. The time includes our coarse film.
#pragma once

#include "core/studies/convergence/film_convergence.h"

namespace touchdown {

FilmMethod establishedMethod();

} // namespace touchdown
