// SPDX-License-Identifier: GPL-3.0-or-later
//
// Progress in one line on standard error: redrawn on a terminal; elsewhere one line a second, if asked for.
#pragma once

#include <chrono>
#include <string>

#include "core/simulation/recording/progress.h"

namespace touchdown {

class ProgressLine {
public:
    /// `always`: not only on a terminal.
    explicit ProgressLine(bool always);
    void show(Progress progress);
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
