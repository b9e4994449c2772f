// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a study of forced motion has found: a motion at each frequency on the way up and on the way down, and the jumps
// between which there are two.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/simulation/recording/quantity.h"
#include "core/studies/hysteresis/value_ranges.h"
#include "core/studies/response/settled_motion.h"

namespace touchdown {

struct ResponseTask {
    Case start;
    Quantity quantity;               // whose amplitude is taken
    double amplitude = 0.0;          // of the wave [m]
    double wavelength = 0.0;         // held while the speed of the disk changes [m]; 0: the speed is held
    std::vector<double> frequencies; // in rising order [Hz]
    SettleOptions settle;
    /// The springs at a frequency [Hz].
    ForcedSprings springsAt(double frequency) const
    {
        return {caseOverWave(start, amplitude, frequency, wavelength), quantity.name};
    }
};

struct ResponsePoint {
    bool down = false; // on the way down
    bool done = false;
    bool anew = false; // began as the case says, as the motion before failed
    ForcedMotion motion;
};

/// A change of the state on one way between two neighbouring frequencies.
struct ResponseJump {
    bool down = false;                     // on the way down
    double before = 0.0, after = 0.0;      // the nearest frequencies on both sides [Hz]
    double left = 0.0, reached = 0.0;      // amplitudes there [unit of the quantity]
    int periodBefore = 1, periodAfter = 1; // of the motions there, in periods of the forcing; 0: has not settled
    double frequency() const { return 0.5 * (before + after); }
};

struct ResponseResult {
    std::vector<ResponsePoint> points;                       // up, then down
    std::vector<std::optional<std::complex<double>>> linear; // Q of small motions at each frequency
    std::vector<ResponseJump> jumps;                         // by rising frequency
};

/// A phase against the disk under the pad is known except for full turns. This is the turn in which those of a result
/// are given: it begins after the widest gap between them, so that no curve crosses its end, and the middle of them is
/// between -270 and 90 degrees.
struct PhaseTurn {
    double lowest = 0.0; // [rad]
    /// Of a harmonic Q [rad].
    double of(const std::complex<double>& harmonic) const;
};
PhaseTurn phaseTurnOf(const ResponseResult& result);

/// The point of a way at the frequency of this place.
const ResponsePoint& pointAt(const ResponseResult& result, std::size_t place, bool down);

/// The places between which both ways have settled into different motions: the first and the last of each range.
std::vector<std::pair<std::size_t, std::size_t>> twoStates(const ResponseResult& result);

/// The jumps at the ends of these ranges. Each is halved in frequency as often as `halvings` says.
std::vector<ResponseJump> jumpsOf(const ResponseTask& task, const ResponseResult& result, int halvings);

/// "flying height" for "flying_height".
std::string readableName(const Quantity& quantity);

/// Frequencies as sentences name them.
ParameterText frequencyText();

} // namespace touchdown
