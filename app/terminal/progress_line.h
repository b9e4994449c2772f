// SPDX-License-Identifier: GPL-3.0-or-later
//
// Progress of a calculation on standard error: one line that is redrawn on a terminal; elsewhere, if asked for, one
// line a second.
#pragma once

#include <chrono>
#include <string>

#include "core/simulation/recording/progress.h"

namespace touchdown {

class ProgressLine {
public:
    /// `always`: not only on a terminal.
    explicit ProgressLine(bool always);

    /// False when the calculation is to stop (app/terminal/stop_signals.h).
    bool show(Progress progress);
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
};

} // namespace touchdown
