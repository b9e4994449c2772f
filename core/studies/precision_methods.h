// SPDX-License-Identifier: GPL-3.0-or-later
//
// Methods and references of a study of accuracy against speed: what they are where nobody says otherwise, and how their
// settings become cases.
#pragma once

#include <string>
#include <vector>

#include "core/studies/measured_run.h"
#include "core/studies/precision_task.h"

namespace touchdown {

/// A method as a study's file writes it.
struct MethodSpec {
    std::string name;
    std::vector<CaseSetting> set;      // on the case
    std::string key;                   // that is swept; empty: none
    std::vector<std::string> values;   // of it, from coarse to fine
    std::vector<std::string> ensemble; // those of them with which ensembles are made
};

/// Springs: every integrator over four decades of steps, whose finest takes up to ten million of them, or eight of tolerances. Film:
/// grids and schemes over the number of nodes; in time also the step error, with both couplings; in a static state also the solvers.
std::vector<MethodSpec> defaultMethods(const Case& c, bool inTime);

/// A method with a case for each of its values, and for the value of the case itself where the method is its own. Of a list that has a
/// fixed length, one number stands for all. The problem in a sentence, or "".
std::string makeMethod(const Case& start, const MethodSpec& spec, PrecisionMethod& method, bool addOwn = true);

/// Finer than any setting of the methods, and of at least two families. Springs: dopri5 at 1e-14, cvode at 1e-13, rk4-events at half
/// of the finest step, with four to forty million of them. Film: adapted and graded grids with half as many nodes more than the finest,
/// in time with a quarter of the smallest step error.
std::vector<PrecisionReference> defaultReferences(const Case& c, bool inTime, const std::vector<PrecisionMethod>& methods);

/// Of an ensemble: springs dopri5 at 1e-12, film a tenth of the case's step error.
PrecisionReference defaultEnsembleReference(const Case& c);

} // namespace touchdown
