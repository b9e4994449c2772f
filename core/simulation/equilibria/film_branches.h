// SPDX-License-Identifier: GPL-3.0-or-later
//
// Equilibria of a slider on its film while one value of its case changes, followed by pseudo-arclength
// (core/numerics/continuation.h) in attitude and parameter. The residual is the force on the slider at an attitude,
// with the film steady there (core/simulation/static_state/film_balance.h). Its Jacobian comes from the response of
// the film, its derivative with respect to the parameter from a difference.
//
//   fold    the branch turns back in the parameter
//   Hopf    the growth of the leading oscillation (core/simulation/small_motions/small_motions.h) changes its sign
//           along the branch
//   switch  the branch meets an end of the interval in which its law of contact holds, and the force jumps
//   kink    the force is continuous there, and the branch continues under the next law
//
// These points are located to `branchesLocatedTo` of the range in arclength. One grid serves the whole range: that of
// the static state in or near its middle; the difference from a grid adapted at each place is within the error of the
// grid. The place where the suspension exerts its load is interpolated between static states. Branches are sought at a
// number of values, flying and in contact; others are missed.
#pragma once

#include <functional>

#include "core/simulation/equilibria/equilibrium.h"

namespace touchdown {

/// Marks and ends are located to this arclength; the range of the parameter is 1 long [-].
inline constexpr double branchesLocatedTo = 1e-4;

/// Between two values, sought at `looks` >= 2 of them; `goOn` is asked all along, with the share of them that is done.
EquilibriumBranches traceFilmBranches(const CaseAt& caseAt, double from, double to, int looks,
                                      const std::function<bool(double share)>& goOn = {});

} // namespace touchdown
