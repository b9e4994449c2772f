// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/progress_line.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include <unistd.h>

#include "app/terminal/report_text.h"
#include "app/terminal/stop_signals.h"
#include "core/formats/quotation.h"
#include "core/work/wall_clock.h"

namespace touchdown {
namespace {

constexpr std::chrono::milliseconds redrawInterval(100);
constexpr std::chrono::seconds lineInterval(1);

} // namespace

ProgressLine::ProgressLine(bool always)
    : terminal_(::isatty(STDERR_FILENO) == 1), shown_(terminal_ || always), next_(Clock::now() + redrawInterval)
{}

bool ProgressLine::show(Progress progress)
{
    if (!shown_) return !stopRequested();
    progress_ = std::move(progress);
    if (!drawn_) timeLeft_.at(progress_.share, wallClock()); // the time counts from the first state
    const Clock::time_point now = Clock::now();
    if (now >= next_) {
        next_ = now + (terminal_ ? Clock::duration(redrawInterval) : Clock::duration(lineInterval));
        std::fprintf(stderr, terminal_ ? "\r%s\x1b[K" : "%s\n", text().c_str());
        std::fflush(stderr);
        drawn_ = true;
    }
    return !stopRequested();
}

void ProgressLine::end()
{
    if (terminal_ && drawn_) std::fputs("\r\x1b[K", stderr);
    if (!terminal_ && shown_) std::fprintf(stderr, "%s\n", text().c_str());
}

std::string ProgressLine::text()
{
    const std::optional<double> left = timeLeft_.at(progress_.share, wallClock());
    std::string line;
    const auto add = [&](const std::string& part) { line += (line.empty() ? "" : ", ") + part; };
    if (progress_.share) add(displayed(100.0 * *progress_.share, "", 3) + " %");
    if (!progress_.activity.empty()) add(progress_.activity);
    for (const ProgressFigure& each : progress_.figures) {
        add(each.name + ' ' + displayed(each.value, each.displayUnit, each.digits));
        if (!each.whole) continue;
        line += " of " + displayed(*each.whole, each.displayUnit, each.digits);
        if (left) add(displayed((*each.whole - each.value) / *left, each.displayUnit, 3) + "/s");
    }
    if (left) add(displayed(*left < 10.0 ? *left : std::round(*left), "s", *left < 10.0 ? 2 : 9) + " left");
    return printable(line);
}

} // namespace touchdown
