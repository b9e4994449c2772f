// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a calculation is, for one line of the terminal and one strip of the window; the time left.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace touchdown {

/// A number beside the share: "residual 2e-05", "time 1.2 ms of 5 ms".
struct ProgressFigure {
    std::string name;
    double value = 0.0;            // SI
    std::string displayUnit{};     // "nm"; empty when dimensionless
    int digits = 3;                // significant ones
    std::optional<double> whole{}; // the value at the end
};

struct Progress {
    std::optional<double> share{};         // done, 0..1; none while it is unknown
    std::string activity{};                // "rk4, 10 ns"; may be empty
    std::vector<ProgressFigure> figures{}; // may be empty
};

/// A run at `time` of `duration` [s]; `minimumSpacing` of all samples so far [m], if there are any.
Progress runProgress(double time, double duration, std::optional<double> minimumSpacing = {});

/// Estimates the time left by the mean rate since the first known share. An unknown share begins anew, so that a run's
/// static state does not count as slow progress.
class TimeLeft {
public:
    /// The time left [s]; none while less than 1 % or 0.5 s is done, and at the end. `now` is wallClock() [s].
    std::optional<double> at(std::optional<double> share, double now);
    /// After a pause.
    void restart() { begin_.reset(); }

private:
    struct Mark {
        double share, seconds;
    };
    std::optional<Mark> begin_;
};

} // namespace touchdown
