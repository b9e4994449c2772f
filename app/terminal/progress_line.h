// SPDX-License-Identifier: GPL-3.0-or-later
//
// A calculation in the terminal: its progress in one line on standard error, redrawn on a terminal, elsewhere one line
// a second if asked for; and its end on request: SIGINT or SIGTERM stops it in good order, the second signal ends the
// program at once. One at a time.
#pragma once

#include <chrono>
#include <csignal>
#include <string>

#include "core/simulation/recording/progress.h"

namespace touchdown {

class ProgressLine {
public:
    /// `always`: not only on a terminal.
    explicit ProgressLine(bool always);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// False when the calculation is to stop.
    bool show(Progress progress);
    bool stopRequested() const;
    /// Removes the line from a terminal; elsewhere writes the last state.
    void end();

private:
    using Clock = std::chrono::steady_clock;

    std::string text();

    bool terminal_;
    bool shown_;
    bool drawn_ = false;
    Clock::time_point next_; // no line before
    Progress progress_;
    TimeLeft timeLeft_;
    struct sigaction interrupt_ {
    }, terminate_{}; // as they were before
};

} // namespace touchdown
