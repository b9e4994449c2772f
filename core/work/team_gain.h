// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether several threads finish loops earlier than one, found by trials now and then: for some milliseconds all loops
// run on one thread, then for as long on all threads, a few times in turn, and the mean times of the same loops are
// compared. On cores that other programs keep busy threads wait for each other, and one may be faster. There a loop
// takes milliseconds now and then, so that the means need some trials. Results do not depend on it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace touchdown {

class TeamGain {
public:
    /// [s] of a steady clock.
    static double now();
    explicit TeamGain(double now) : next_(now + firstWait) {}

    /// Whether loops are shared at present.
    bool together() const { return phase_ == Phase::Together || (phase_ == Phase::Use && together_); }
    /// Whether each loop's time is wanted.
    bool measures() const { return phase_ != Phase::Use; }
    /// Time of a loop [s]; `loop`: any number but 0 that is the same for loops of the same kind.
    void note(std::uintptr_t loop, double seconds);
    /// To be called often. Begins and ends trials.
    void look(double now);
    /// Time on one thread over that on all, of the last trials; 0: not measured yet.
    double gain() const { return gain_; }

private:
    static constexpr double firstWait = 0.05, longestWait = 3.0; // between trials [s]
    static constexpr double half = 0.008;                        // length of each half of a round [s]
    static constexpr int mostRounds = 6;                         // of a trial

    enum class Phase : std::uint8_t { Use, Alone, Together };
    struct Loop {
        std::uintptr_t key = 0;
        std::array<double, 2> time{}; // on one thread, on all [s]
        std::array<double, 2> calls{};
    };
    /// Begins or ends a trial.
    void begin();
    void decide();

    Phase phase_ = Phase::Use;
    bool together_ = true;
    double next_, wait_ = firstWait;  // when the phase ends; between trials [s]
    int rounds_ = 0, lastRounds_ = 0; // left of the trial, of the last one
    double gain_ = 0.0;
    std::array<Loop, 128> loops_{};
};

} // namespace touchdown
