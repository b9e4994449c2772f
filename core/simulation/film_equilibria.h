// SPDX-License-Identifier: GPL-3.0-or-later
//
// Equilibria of a slider on its film over a flat disk under Ono and Yamane's characteristic, of one case:
//
//   film(q) + contact(q) + suspension(q) = 0,   q = (height of the mass centre, pitch, roll)
//
// with the film steady at q. Flying: the static state, where it is above d_s. In contact, on the take-off branch: Newton's method with the
// stiffnesses of film and contact, from the static attitude set down to several separations and from attitudes that are known
// to be near. One that no start leads to is missed.
//
// Small motions about each: the s for which (s^2 M + s C + K + K_contact + Z(s)) q = 0, with the film's Z(s) in full
// (core/simulation/film_modes.h); of each oscillation one s is told. Where the static stiffness has a negative determinant a motion grows
// without oscillating.
#pragma once

#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "core/physics/attitude.h"
#include "core/simulation/case.h"
#include "core/simulation/spring_equilibria.h"

namespace touchdown {

struct FilmEquilibrium {
    Attitude attitude;
    double spacing = 0.0;                          // minimum spacing [m]
    bool touching = false;                         // on the take-off branch: pressed, or held by menisci
    double netContactForce = 0.0;                  // [N]
    std::vector<std::complex<double>> eigenvalues; // of the oscillations, by falling real part [1/s]
    Stability stability = Stability::Stable; // as far as the motions tell that were followed
    int lost = 0;                            // oscillations that were not
};

struct FilmEquilibria {
    bool stopped = false;
    std::string problem; // why nothing was sought, in a sentence
    std::vector<FilmEquilibrium> found;
    int lost = 0;          // oscillations that could not be followed
    int givenUp = 0;       // starts from which the film was not solved or Newton's method did not end
    double resolved = 0.0; // frequency above which the grid is too coarse for their damping [Hz]
};

/// Why there are none of this case, in a sentence; "" where they can be sought.
std::string reasonForNoFilmEquilibria(const Case& c);

FilmEquilibria filmEquilibria(const Case& c, const std::vector<Attitude>& near, const std::function<bool()>& goOn);

} // namespace touchdown
