// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_pace.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

namespace {

constexpr double pictureRate = 60.0;  // [1/s]
constexpr double stepsPerRun = 200.0; // of a paused run at full speed
constexpr double shortestWait = 8e-3; // [s]
constexpr double longestWait = 1.0;   // [s]

} // namespace

void RunPace::reset()
{
    paused_ = anchored_ = false;
    steps_ = 0;
    shownTime_ = stepUntil_ = 0.0;
}

void RunPace::begin(double time) { shownTime_ = stepUntil_ = timeAnchor_ = time; }

void RunPace::setPaused(bool paused)
{
    {
        const std::lock_guard lock(orders_);
        paused_ = paused;
        steps_ = 0;
        anchored_ = false;
    }
    ordered_.notify_all();
}

void RunPace::step()
{
    {
        const std::lock_guard lock(orders_);
        ++steps_;
    }
    ordered_.notify_all();
}

void RunPace::set(double simulatedPerWallSecond)
{
    {
        const std::lock_guard lock(orders_);
        pace_ = simulatedPerWallSecond;
        anchored_ = false;
    }
    ordered_.notify_all();
}

std::optional<std::size_t> RunPace::waitForSlice(std::span<const double> times, std::size_t begin, double duration,
                                                 const std::stop_token& stop)
{
    const auto handOutUntil = [&](double time) -> std::optional<std::size_t> {
        const auto end = static_cast<std::size_t>(std::ranges::upper_bound(times, time) - times.begin());
        if (end <= begin) return std::nullopt;
        shownTime_ = times[end - 1];
        return end;
    };
    std::unique_lock lock(orders_);
    while (!stop.stop_requested()) {
        if (paused_) {
            if (steps_ > 0) {
                --steps_;
                const double length = std::isfinite(pace_) ? pace_ / pictureRate : duration / stepsPerRun;
                // At least to the next sample.
                stepUntil_ = std::max(times[begin], shownTime_ + length);
            }
            if (const auto end = handOutUntil(stepUntil_)) return end;
            ordered_.wait(lock, stop, [this] { return !paused_ || steps_ > 0; });
            continue;
        }
        stepUntil_ = -std::numeric_limits<double>::infinity();
        if (!std::isfinite(pace_)) return handOutUntil(std::numeric_limits<double>::infinity());

        const Clock::time_point now = Clock::now();
        if (!anchored_) {
            anchored_ = true;
            wallAnchor_ = now;
            timeAnchor_ = shownTime_;
        }
        const double passed = std::chrono::duration<double>(now - wallAnchor_).count();
        if (const auto end = handOutUntil(timeAnchor_ + pace_ * passed)) return end;

        const double due = (times[begin] - timeAnchor_) / pace_ - passed; // [s] from now
        const std::chrono::duration<double> wait(std::clamp(due, shortestWait, longestWait));
        // An order clears the anchor.
        ordered_.wait_for(lock, stop, wait, [this] { return !anchored_; });
    }
    return std::nullopt;
}

void RunPace::waitWhilePaused(const std::stop_token& stop)
{
    std::unique_lock lock(orders_);
    ordered_.wait(lock, stop, [this] { return !paused_ || steps_ > 0 || stepUntil_ > shownTime_; });
}

} // namespace touchdown
