// SPDX-License-Identifier: GPL-3.0-or-later
//
// When the samples of a run are handed out: pause, single steps, slow motion. The window gives the orders; the worker
// waits here between the slices of a batch. The solver's arithmetic is not affected, only its waiting time.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <limits>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>

namespace touchdown {

class RunPace {
public:
    static constexpr double fullSpeed = std::numeric_limits<double>::infinity();

    // Called by the window.
    /// Before a run starts, while no worker uses this: at its start, not paused.
    void reset();
    void setPaused(bool paused);
    /// Hands out the samples of one more picture while paused.
    void step();
    /// Simulated seconds per second of wall time.
    void set(double simulatedPerWallSecond);
    double value() const { return pace_; }

    // Called by the worker.
    /// Waits until samples from `begin` on may be shown, and returns the end of that slice; none after a stop.
    std::optional<std::size_t> waitForSlice(std::span<const double> times, std::size_t begin, double duration,
                                            const std::stop_token& stop);
    void waitWhilePaused(const std::stop_token& stop);
    /// Samples until a time have been handed out at once [s].
    void begin(double time);
    /// Time of the last sample handed out [s].
    double shownTime() const { return shownTime_; }

private:
    using Clock = std::chrono::steady_clock;

    std::mutex orders_;
    std::condition_variable_any ordered_;
    double pace_ = fullSpeed; // [s/s]
    bool paused_ = false;
    int steps_ = 0;
    bool anchored_ = false;

    // Used by the worker alone.
    Clock::time_point wallAnchor_;
    double timeAnchor_ = 0.0; // [s]
    double shownTime_ = 0.0;  // [s]
    double stepUntil_ = 0.0;  // [s]
};

} // namespace touchdown
