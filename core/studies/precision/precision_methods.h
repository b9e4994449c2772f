// SPDX-License-Identifier: GPL-3.0-or-later
//
// Methods and references of a study of accuracy against speed where nobody says otherwise.
#pragma once

#include <vector>

#include "core/studies/runs/proven_reference.h"
#include "core/studies/runs/swept_method.h"

namespace touchdown {

/// Springs: every integrator over four decades of steps, whose finest takes up to ten million of them, or eight of
/// tolerances. Film: grids and schemes over the number of nodes; in time also the step error, with both couplings; in a
/// static state also the solvers.
std::vector<MethodSpec> defaultMethods(const Case& c, bool inTime);

/// Finer than any setting of the methods. Springs: rk4-events at half of the finest step, with four to forty million of
/// them. Film: grids with half as many nodes more than the finest, in time with a quarter of the smallest step error.
std::vector<ReferenceCase> defaultReferences(const Case& c, bool inTime, const std::vector<SweptMethod>& methods);

} // namespace touchdown
