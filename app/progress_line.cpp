// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress_line.h"

#include <algorithm>
#include <cstdio>

#include <unistd.h>

#include "core/simulation/units.h"

namespace touchdown {
namespace {

constexpr std::chrono::milliseconds redrawInterval(100);
constexpr std::chrono::seconds lineInterval(1);

} // namespace

ProgressLine::ProgressLine(bool always, const std::vector<Quantity>& quantities)
    : terminal_(::isatty(STDERR_FILENO) == 1),
      shown_(terminal_ || always),
      spacing_(findQuantity(quantities, "minimum_spacing"))
{
    next_ += redrawInterval;
}

void ProgressLine::show(const RunUpdate& update)
{
    if (!shown_) return;
    time_ = update.time;
    duration_ = update.duration;
    if (spacing_ >= 0 && update.samples.size() > 0) {
        const std::vector<double>& column = update.samples.columns[static_cast<std::size_t>(spacing_)];
        const double least = *std::min_element(column.begin(), column.end());
        minimum_ = sampled_ ? std::min(minimum_, least) : least;
        sampled_ = true;
    }
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + (terminal_ ? Clock::duration(redrawInterval) : Clock::duration(lineInterval));
    std::fprintf(stderr, terminal_ ? "\r%s\x1b[K" : "%s\n", text().c_str());
    std::fflush(stderr);
    drawn_ = true;
}

void ProgressLine::end()
{
    if (terminal_ && drawn_) std::fputs("\r\x1b[K", stderr);
    if (!terminal_ && shown_) std::fprintf(stderr, "%s\n", text().c_str());
}

std::string ProgressLine::text() const
{
    const double elapsed = std::chrono::duration<double>(Clock::now() - begin_).count();
    const double rate = elapsed > 0.0 ? time_ / elapsed : 0.0; // simulated seconds per second
    std::string line = displayed(time_, "ms") + " of " + displayed(duration_, "ms");
    if (duration_ > 0.0) line += " (" + displayed(100.0 * time_ / duration_, "", 3) + " %)";
    line += ", " + displayed(rate, "ms", 3) + "/s";
    if (rate > 0.0) line += ", " + displayed((duration_ - time_) / rate, "s", 3) + " left";
    if (sampled_) line += ", minimum spacing " + displayed(minimum_, "nm");
    return line;
}

std::string displayed(double value, const std::string& displayUnit, int digits)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, displayUnit.empty() ? value : value / unitFactor(displayUnit));
    return displayUnit.empty() ? text : std::string(text) + " " + displayUnit;
}

} // namespace touchdown
