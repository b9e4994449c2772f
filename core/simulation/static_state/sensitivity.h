// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sensitivities of a flying attitude to every continuous parameter, from its adjoint: three adjoint films serve all
// parameters, each of which costs two evaluations of the film's residual on the same grid.
#pragma once

#include <vector>

#include "core/simulation/static_state/steady.h"

namespace touchdown {

class MinimumSpacing;
struct FilmLevel;

/// The level must be solved for its flying attitude.
std::vector<Sensitivity> sensitivities(const Case& c, FilmLevel& level, const MinimumSpacing& spacing);

} // namespace touchdown
