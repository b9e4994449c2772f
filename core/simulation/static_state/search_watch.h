// SPDX-License-Identifier: GPL-3.0-or-later
//
// When the search for a flying attitude is given up, and the last sane state to report then.
//
// From far, on the coarsest grid, a search may pass through attitudes at which rails dip into the disk and come out of
// it again: from a start of 3000 urad it went 27 nm deep. On a finer grid it starts above the disk; where it comes down
// onto it, only contact could carry the rest of the load. The limits lie beyond all searches that found a flying
// attitude: the deepest went 59 nm below the disk's mean plane, the highest corner rose to 17 um, the load error did
// not improve over 69 attitudes on a coarse grid and 39 on a finer one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/physics/slider/attitude.h"

namespace touchdown {

/// Why a search was given up.
enum class NoBalance : std::uint8_t {
    None,
    AtDisk,      // the rails came down onto the disk, where the film was not solved or the search may not pass through
    BelowDisk,   // the rails went too deep into the disk: the film does not carry the load
    FarAway,     // a corner rose too high: nothing holds the slider near the disk
    Stalled,     // the forces came no nearer to balance
    FilmUnsolved // the film was not solved at several attitudes
};
/// The reason in words, as the rest of "no flying attitude was found: ...".
std::string_view reason(NoBalance why);

class SearchWatch {
public:
    static constexpr double deepest = 100e-9; // below the disk's mean plane [m]
    static constexpr double highest = 50e-6;  // of the slider's corners above it; twice that of a higher start [m]
    static constexpr int mostUnsolved = 3;    // attitudes with a sane spacing at which the film was not solved

    static constexpr double touching = 1e-12; // a smaller minimum spacing has come down onto the disk [m]
    static constexpr double leastSane =
        0.1e-9; // a film of a smaller minimum spacing, less than an atom, is not sane [m]

    /// The highest corner of the start [m]; attitudes without improvement that are allowed; whether rails may pass
    /// through the disk.
    SearchWatch(double startCorner, int patience, bool throughDisk);

    /// An attitude at which the film was not solved: several are allowed above the disk, one of less than leastSane.
    NoBalance unsolved(double spacing);

    struct State {
        double spacing;   // minimum [m]
        double corner;    // the highest, of recess 0 [m]
        double residual;  // of the film [-]
        double loadError; // [-]
        bool solved;      // the film
    };
    /// An attitude of the search, and the pressure there.
    NoBalance look(const Attitude& attitude, const State& state, std::span<const double> pressure);

    /// The last attitude with rails clearly above the disk at which the film was solved.
    struct Sane {
        Attitude attitude;
        State state;
    };
    const std::optional<Sane>& lastSane() const { return sane_; }
    const std::vector<double>& sanePressure() const { return pressure_; }
    /// The least load error of all sane states; 1 when there was none [-].
    double leastSaneError() const { return leastSane_; }

private:
    double highest_; // [m]
    int patience_;
    bool throughDisk_;
    int stalled_ = 0, unsolved_ = 0, unsolvedLow_ = 0;
    double best_ = 0.0, leastSane_ = 1.0; // load errors [-]
    bool started_ = false;
    std::optional<Sane> sane_;
    std::vector<double> pressure_;
};

} // namespace touchdown
