// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a run is, on standard error.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "app/terminal/live_line.h"
#include "core/simulation/run.h"

namespace touchdown {

class ProgressLine {
public:
    ProgressLine(bool always, const std::vector<Quantity>& quantities);
    void show(const RunUpdate& update);
    void end();

private:
    using Clock = std::chrono::steady_clock;

    std::string text() const;

    LiveLine line_;
    int spacing_; // column of the minimum spacing
    Clock::time_point begin_ = Clock::now();
    double time_ = 0.0;     // simulated [s]
    double duration_ = 0.0; // [s]
    double minimum_ = 0.0;  // spacing, of all samples [m]
    bool sampled_ = false;
};

/// 1.234e-3 in "ms": "1.234 ms", with so many significant digits.
std::string displayed(double value, const std::string& displayUnit, int digits = 4);

} // namespace touchdown
