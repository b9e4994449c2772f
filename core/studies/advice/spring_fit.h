// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two lumped air springs that stand for a film: the springs case nearest to a film case about its static state.
//
// The film's stiffness of height and pitch about the mass centre, K (symmetric part, at the middle of its two modes'
// frequencies), has three numbers; two springs have four, k_f0, k_r0, d_f, d_r. The rear spring is put where the slider
// is lowest, since the spacing there decides near the disk. With the mean arm m = K_12/K_11 and the variance v =
// K_22/K_11 - m^2:
//
//   d_f = m + v/(m + d_r),  k_f0 = K_11 (m + d_r)/(d_f + d_r),  k_r0 = K_11 - k_f0
//
// The dashpots give both modes the damping ratios of the film's modes; a negative one is left out. Static spacing and
// pitch, suspension, contact characteristic, start and the disk's surface are taken over; the springs follow its
// heights under three places. Two springs cannot represent roll, an asymmetric K, its change with frequency, and the
// film's own law of spacing; theirs is k_0 z_0^2 (z_0 - z)/z^2.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "core/case/case.h"

namespace touchdown {

struct SpringFit {
    std::string problem;        // why there is none, in a sentence; "" where there is one
    Case springs;               // of model "springs"
    double stiffnessLeft = 0.0; // |K - K of the springs|/|K|, in lengths of the slider [-]
    std::array<double, 2> filmFrequency{}, springFrequency{}; // of the modes [Hz]
    std::array<double, 2> filmDamping{}, springDamping{};     // their damping ratios [-]
};

/// Springs follow the disk's surface under them, but not ellipsoids that move: their sides are vertical at the base.
bool springsKnowDisk(const Case& c);

/// `c` is a valid case of model "film". `goOn` is asked within; false ends with a problem.
SpringFit fitSprings(const Case& c, const std::function<bool()>& goOn = {});

} // namespace touchdown
