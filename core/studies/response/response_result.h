// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a study of forced motion has found: a motion at each frequency on the way up and on the way down, other motions
// that drawn starts have reached, and the jumps at which motions end.
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/simulation/recording/quantity.h"
#include "core/studies/response/settled_motion.h"
#include "core/studies/runs/value_ranges.h"

namespace touchdown {

struct ResponseTask {
    Case start;
    Quantity quantity;               // whose amplitude is taken
    double amplitude = 0.0;          // of the wave [m]
    double wavelength = 0.0;         // held while the speed of the disk changes [m]; 0: the speed is held
    std::vector<double> frequencies; // in rising order [Hz]
    double beat =
        0.0; // of the waves under both air springs, or under both ends of a film, where the speed is held [Hz]; else 0
    std::string under = "the pad";            // the disk against which phases are given
    std::string ends = "the two air springs"; // whose waves beat
    int starts = 0;                           // from which other motions are looked for
    SettleOptions settle;
    std::vector<double> outside; // frequencies of vibrations about a film's static state that are not in the range [Hz]
    std::optional<double> toContact; // of a law with a touch-down height: from the static state down to it [m]
    /// At a frequency [Hz].
    std::function<std::unique_ptr<ForcedSlider>(double frequency)> sliderAt;
};

struct ResponsePoint {
    bool down = false; // on the way down
    bool done = false;
    bool anew = false; // began as the case says, as the motion before failed
    ForcedMotion motion;
};

/// A motion that ends, followed up or down, where the slider reaches a different one.
struct ResponseJump {
    bool down = false;          // on the way down
    int other = 0;              // of the other motion with this number; 0: of the sweep
    ForcedMotion before, after; // at its last frequency; what is reached, there or as near as it exists
    double beyond = 0.0;        // the nearest frequency at which the motion before was not found [Hz]
    double frequency() const { return 0.5 * (before.frequency + beyond); }
    double uncertainty() const { return std::abs(beyond - before.frequency); } // [Hz]
};

/// A motion that is not on either way: neighbouring points by rising frequency.
struct OtherMotion {
    std::size_t first = 0;             // place of the first frequency
    std::vector<ForcedMotion> motions; // at neighbouring frequencies
    int starts = 0;                    // that have reached it
    /// At the frequency of this place; null where it is not.
    const ForcedMotion* at(std::size_t place) const
    {
        return place >= first && place - first < motions.size() ? &motions[place - first] : nullptr;
    }
};

struct ResponseResult {
    std::vector<ResponsePoint> points;                       // up, then down
    std::vector<std::optional<std::complex<double>>> linear; // Q of small motions at each frequency
    std::vector<ResponseJump> jumps;
    std::vector<OtherMotion> others;
    int starts = 0, unsettled = 0; // starts that were followed; those that have not settled or failed
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

/// The sweep's last jump on a way from the frequency of a place to that of its neighbour; null where there is none. Two
/// states at the place, of which there is one at the neighbour, end there.
const ResponseJump* jumpBetween(const ResponseTask& task, const ResponseResult& result, std::size_t place,
                                std::size_t next, bool down);

/// "flying height" for "flying_height".
std::string readableName(const Quantity& quantity);

/// Frequencies as sentences name them.
ParameterText frequencyText();

} // namespace touchdown
