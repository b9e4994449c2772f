// SPDX-License-Identifier: GPL-3.0-or-later
//
// A line on standard error that says how far something is: redrawn on a terminal; lines, if asked for, elsewhere.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace touchdown {

class LiveLine {
public:
    explicit LiveLine(bool always);
    /// Asks for the text when it is time to draw it.
    void show(const std::function<std::string()>& text);
    /// Removes the line from a terminal; elsewhere writes the last state.
    void end(const std::function<std::string()>& text);
    bool shown() const { return shown_; }

private:
    using Clock = std::chrono::steady_clock;

    bool terminal_;
    bool shown_;
    bool drawn_ = false;
    Clock::time_point next_; // no line before
};

} // namespace touchdown
