// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static states that cannot exist, found before anything is computed, the words for searches that found none, and
// what to know of a state that was found.
//
// - A flying attitude needs a moving disk: over one at rest the steady film has ambient pressure everywhere and carries
//   nothing. A slider in contact: contact_rest.h. Without a load every height is a static state then: that of the
//   initial attitude is taken, as for a squeeze film.
// - A film at a fixed attitude needs rails above the mean plane of the disk. Where the gap is closed the film's
//   equation does not hold. With a contact law in the case such an attitude occurs in runs in time, where contact
//   carries the rails; its film is solved with a least gap (FilmSetting), and the result says so.
#pragma once

#include <optional>
#include <string>

#include "core/physics/slider/minimum_spacing.h"

namespace touchdown {

struct Case;
struct SteadyResult;

/// Why the case has no static state; "" if it may have one.
std::string whyNoStaticState(const Case& c, const MinimumSpacing& spacing);

/// The initial attitude where the disk is at rest and the suspension exerts neither force nor torque; a suspension that
/// holds an attitude gives pitch and roll.
std::optional<Attitude> unloadedRest(const Case& c);

/// What to know of a film that was solved at a fixed attitude with rails below the mean plane; "" if there are none.
std::string noteOnClosedGap(const Case& c, const MinimumSpacing& spacing);

/// What a roll that is held leaves unbalanced; "" if the roll is free, the attitude is given or nothing is left.
///
/// With two degrees of freedom the balance has no equation for roll. Film, shear, suspension and load then exert
///   T = T_film - a F_shear,y + T_load - K_roll (roll - roll_static)
/// on the slider, as the force F of the film would at the distance T / F from the centre line.
std::string noteOnHeldRoll(const Case& c, const SteadyResult& state);

/// "trailing edge height 20 nm, pitch 150 urad, roll 0 urad"
std::string attitudeWords(const Attitude& attitude);
/// The last state of a search that was given up: attitude, minimum spacing, force of the film and preload.
std::string lastStateWords(const Case& c, const SteadyResult& state);

} // namespace touchdown
