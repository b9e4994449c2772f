// SPDX-License-Identifier: GPL-3.0-or-later
//
// Equilibria of a slider on its film over a flat disk under Ono and Yamane's characteristic, of one case. Flying: the
// static state, where it is above d_s. In contact, on the take-off branch:
// core/simulation/static_state/touching_places.h. An equilibrium that no start leads to is missed.
//
// Stability: the oscillations about each (core/simulation/small_motions/small_motions.h); where the static stiffness
// has a negative determinant a motion grows without oscillating.
#pragma once

#include <complex>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/simulation/equilibria/equilibrium.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown {

class FilmBalance;

struct FilmEquilibria {
    bool stopped = false;
    std::string problem; // why nothing was sought, in a sentence
    std::vector<Equilibrium> found;
};

/// Why there are none of this case, in a sentence; "" where they can be sought.
std::string reasonForNoFilmEquilibria(const Case& c);

FilmEquilibria filmEquilibria(const Case& c, const std::function<bool()>& goOn);

/// The static state of a case's film, over a flat disk: grid, and where the suspension exerts its load.
SteadyResult staticStateOf(const Case& c, const std::function<bool()>& goOn);

/// The equilibrium at the balance's last place, where it is solved; `near`: the rates of one close by.
Equilibrium describeEquilibrium(FilmBalance& balance, ContactRegion region, std::span<const std::complex<double>> near,
                                const std::function<bool()>& goOn);

} // namespace touchdown
