// SPDX-License-Identifier: GPL-3.0-or-later
//
// The motion into which a slider settles over one wave of the disk.
//
// The motion is followed period by period. After 8, 16, 32, ... periods the smallest number n of periods is taken after
// which the state nearly repeats, and Newton's method on P^n(y) - y = 0 (forced_motion.h) finds the motion that
// repeats exactly. It is taken where it is stable (all multipliers inside the unit circle) and the motion has come
// within a tenth of its size, and nearer than at the look before. A motion that repeats by itself to round-off is taken
// as it is. Where neither comes true within the most periods, the motion has not settled: it is irregular, has a longer
// period than was sought, or decays too slowly. Its figures are then those of its last periods.
#pragma once

#include <complex>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "core/studies/response/forced_motion.h"

namespace touchdown {

struct SettleOptions {
    int mostPeriods = 1000; // of the forcing, until the motion has settled
    int longestPeriod = 8;  // N: periods of the forcing after which a motion may repeat
    std::function<bool()> goOn{};
};

struct ForcedMotion {
    double frequency = 0.0;           // of the forcing [Hz]
    std::string problem;              // why there is no motion, in a sentence without a full stop
    int period = 0;                   // n, in periods of the forcing; 0: has not settled, or nothing is known
    std::optional<double> multiplier; // largest magnitude [-]; nothing where Newton's method found none
    std::complex<double> harmonic;    // Q, see forced_motion.h [unit of the quantity]
    double least = 0.0, most = 0.0;   // of the quantity [its unit]
    double leastSpacing = 0.0;        // of pad and pressure centres [m]
    double touchDowns = 0.0;          // in one period of the forcing
    double contactShare = 0.0;        // of the time, 0..1
    ForcedState end;                  // at the beginning of a period
    Eigen::VectorXd size = Eigen::VectorXd::Zero(1); // where it has settled: ForcedSlider::units
    bool valid() const { return problem.empty(); }
    bool settled() const { return valid() && period > 0; }
    double amplitude() const { return std::abs(harmonic); }
};

/// From `start`; a stopped motion has a problem.
ForcedMotion settledMotion(const ForcedSlider& slider, const ForcedState& start, const SettleOptions& options);

/// A stable motion that repeats, at the beginning of a period.
struct RepeatingMotion {
    ForcedState at;
    int period = 1;          // n, in periods of the forcing
    double multiplier = 0.0; // largest magnitude over n periods [-]
    Eigen::VectorXd size;    // of the motion: ForcedSlider::units
};
struct NewtonOptions {
    double reach = 2.0; // of the motion from the start [sizes of the motion]
    int mostSteps = 12;
    bool rough = false; // in a quarter of the time (ForcedRequest)
};
/// By Newton's method from `start`, which nearly repeats after n periods; nothing where it finds no stable motion
/// within reach. `size` of the motion as above.
std::optional<RepeatingMotion> repeatingNear(const ForcedSlider& slider, const ForcedState& start, int n,
                                             const Eigen::VectorXd& size, const NewtonOptions& newton,
                                             const std::function<bool()>& goOn);
/// Distance of two states in units of `size` [-].
double apart(const ForcedState& a, const ForcedState& b, const Eigen::VectorXd& size);
/// With the figures of its n periods.
ForcedMotion measured(const ForcedSlider& slider, const RepeatingMotion& motion);

/// Whether two motions at the same frequency are the same: both have settled, with the same period, and differ by less
/// than a thousandth in their harmonics, and, as a quantity may not tell them apart, in their least spacing (of their
/// size) and share of contact.
bool sameMotion(const ForcedMotion& a, const ForcedMotion& b);

} // namespace touchdown
