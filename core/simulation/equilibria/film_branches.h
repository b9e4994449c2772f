// SPDX-License-Identifier: GPL-3.0-or-later
//
// Equilibria of a slider on its film while one value of its case changes, followed by pseudo-arclength
// (core/numerics/continuation.h) in attitude and parameter: each residual is the force on the slider at an attitude,
// with the film steady there (core/simulation/small_motions/film_balance.h); its Jacobian comes from what the film
// answers, the parameter's from a difference.
//
//   fold    the branch turns back in the parameter
//   Hopf    the growth of the leading oscillation (core/simulation/small_motions/film_oscillations.h) changes its sign
//   along the branch switch  the branch meets an end of the interval in which its law of contact holds: the force jumps
//   there, or goes on with a kink, and
//           then the branch goes on under the next law
//
// located to `locatedTo` of the range in arclength. One grid serves the whole range, that of the static state in its
// middle or next to it: a branch differs from what a grid adapted at its place would give by no more than the grid's
// error. Where the suspension exerts its load is interpolated between static states. Branches are sought at a number of
// values, flying and in contact; others are missed.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/simulation/equilibria/film_path.h"

namespace touchdown {

/// A branch under one law.
struct FilmBranch {
    ContactRegion region = ContactRegion::Apart; // the lowest one of its law
    std::vector<FilmBranchPoint> points;         // in their order along it
};

struct MarkedFilmEquilibrium {
    EquilibriumMark kind = EquilibriumMark::Fold;
    FilmBranchPoint at;
    std::string name; // "touch-down": of a switch or a kink; else that of the kind
};

struct FilmBranches {
    static constexpr double locatedTo = 1e-4; // arclength; the range of the parameter is 1 long [-]

    bool stopped = false;
    std::vector<FilmBranch> branches;
    std::vector<MarkedFilmEquilibrium> marks;
    std::vector<std::string> problems; // of values at which nothing was sought, in sentences
    int endsLost = 0;      // ends of branches that were not explained: the case is not valid beyond, or a step failed
    int givenUp = 0;       // values at which the search in contact did not come to its end from every start
    double resolved = 0.0; // least frequency up to which the grid knows an oscillation's damping [Hz]
};

/// Between two values, sought at `looks` >= 2 of them; `goOn` is asked all along, with the share of them that is done.
FilmBranches traceFilmBranches(const CaseAt& caseAt, double from, double to, int looks,
                               const std::function<bool(double share)>& goOn = {});

} // namespace touchdown
