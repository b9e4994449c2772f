// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/progress.h"

namespace touchdown {

namespace {

constexpr double leastShare = 0.01, leastSeconds = 0.5; // done before an estimate is useful

} // namespace

Progress runProgress(double time, double duration, std::optional<double> minimumSpacing)
{
    Progress progress;
    if (time > 0.0 && duration > 0.0)
        progress.share = time / duration;
    else
        progress.activity = "preparing"; // a film run begins with its static state
    progress.figures.push_back({"time", time, "ms", 4, duration});
    if (minimumSpacing) progress.figures.push_back({"minimum spacing", *minimumSpacing, "nm", 4});
    return progress;
}

std::optional<double> TimeLeft::at(std::optional<double> share, double now)
{
    if (!share) begin_.reset();
    if (!share) return {};
    if (!begin_) begin_ = {*share, now};
    const double done = *share - begin_->share, seconds = now - begin_->seconds;
    if (done < leastShare || seconds < leastSeconds || *share >= 1.0) return {};
    return seconds * (1.0 - *share) / done;
}

} // namespace touchdown
