// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small motions of a slider about an equilibrium with its film: the s for which
//
//   (s^2 M + s C + K + K_contact + Z(s)) q = 0
//
// with the film's Z(s) in full. For a trial s the film is written as Z = K_f + s C_f with real K_f, C_f, as in
// core/simulation/small_motions/film_modes.h; the eigenvalue g(s) of that quadratic problem next to s is compared with
// s, and g(s) = s solved by secants. Of each oscillation one s is told, that with a positive frequency.
#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "core/simulation/small_motions/film_balance.h"

namespace touchdown {

struct FilmOscillations {
    std::vector<std::complex<double>> rates; // by falling real part [1/s]
    int lost = 0; // of the degrees of freedom: could not be followed, or so much damped that it does not oscillate
};

/// At the balance's last place, where it is solved, in a region of the contact law. `near`: rates of an equilibrium
/// close by; may be empty.
FilmOscillations filmOscillations(FilmBalance& balance, ContactRegion region, const FilmOscillations& near,
                                  const std::function<bool()>& goOn);

/// Frequency up to which the grid knows how an oscillation is damped [Hz]. What it presses into the film is dragged
/// along at half the disk's speed, in waves U/(2 f) long: of fewer than ten cells each they take from its damping, or
/// add to it (core/simulation/small_motions/modes.cpp).
double resolvedFrequency(FilmBalance& balance);

} // namespace touchdown
