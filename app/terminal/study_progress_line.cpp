// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/study_progress_line.h"

#include <cmath>

#include "app/terminal/progress_line.h"

namespace touchdown {

namespace {

constexpr double leastShare = 0.02; // below it a guess of the time left means nothing

} // namespace

void StudyProgressLine::show(const StudyProgress& progress)
{
    if (!line_.shown()) return;
    share_ = progress.share;
    doing_ = progress.doing;
    line_.show([this] { return text(); });
}

void StudyProgressLine::end()
{
    line_.end([this] { return text(); });
}

std::string StudyProgressLine::text() const
{
    const double elapsed = std::chrono::duration<double>(Clock::now() - begin_).count();
    std::string line = displayed(100.0 * share_, "", 3) + " %";
    if (!doing_.empty()) line += ", " + doing_;
    if (share_ < leastShare || share_ >= 1.0) return line;
    const double left = elapsed * (1.0 - share_) / share_;
    return line + ", " + (left < 10.0 ? displayed(left, "s", 2) : std::to_string(std::lround(left)) + " s") + " left";
}

} // namespace touchdown
