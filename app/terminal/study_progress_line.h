// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a study is, on standard error.
#pragma once

#include <chrono>
#include <string>

#include "app/terminal/live_line.h"
#include "core/studies/study/study.h"

namespace touchdown {

class StudyProgressLine {
public:
    explicit StudyProgressLine(bool always) : line_(always) {}
    void show(const StudyProgress& progress);
    void end();

private:
    using Clock = std::chrono::steady_clock;

    std::string text() const;

    LiveLine line_;
    Clock::time_point begin_ = Clock::now();
    double share_ = 0.0;
    std::string doing_;
};

} // namespace touchdown
