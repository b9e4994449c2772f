// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/progress_line.h"

#include <algorithm>
#include <cstdio>

#include "core/formats/units.h"

namespace touchdown {

ProgressLine::ProgressLine(bool always, const std::vector<Quantity>& quantities)
    : line_(always), spacing_(findQuantity(quantities, "minimum_spacing"))
{}

void ProgressLine::show(const RunUpdate& update)
{
    if (!line_.shown()) return;
    time_ = update.time;
    duration_ = update.duration;
    if (spacing_ >= 0 && update.samples.size() > 0) {
        const std::vector<double>& column = update.samples.columns[static_cast<std::size_t>(spacing_)];
        const double least = *std::min_element(column.begin(), column.end());
        minimum_ = sampled_ ? std::min(minimum_, least) : least;
        sampled_ = true;
    }
    line_.show([this] { return text(); });
}

void ProgressLine::end()
{
    line_.end([this] { return text(); });
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
