// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a static solution is, on standard error.
#pragma once

#include <cstddef>
#include <string>

#include "app/terminal/live_line.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown {

class SteadyProgressLine {
public:
    /// `states` of a series.
    SteadyProgressLine(bool always, std::size_t states) : line_(always), states_(states) {}
    void begin(std::size_t state) { state_ = state; } // from 0
    void show(const SteadyProgress& progress);
    void end();

private:
    std::string text() const;

    LiveLine line_;
    std::size_t states_;
    std::size_t state_ = 0;
    SteadyProgress last_;
};

} // namespace touchdown
