// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/run_updates.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace touchdown {

namespace {

constexpr double longestSilence = 0.015; // [s]
constexpr std::size_t mostEvents = 100'000;

} // namespace

RunUpdates::RunUpdates(std::size_t quantities, double duration, const RunCallback& callback)
    : duration_(duration), callback_(callback)
{
    samples_.time.reserve(samplesInBatch);
    samples_.columns.resize(quantities);
    for (std::vector<double>& column : samples_.columns) column.reserve(samplesInBatch);
}

void RunUpdates::addSample(double time, std::span<const double> values)
{
    samples_.time.push_back(time);
    for (std::size_t i = 0; i < values.size(); ++i) samples_.columns[i].push_back(values[i]);
}

void RunUpdates::addEvent(double time, std::string name)
{
    if (events_.size() + newEvents_.size() < mostEvents) newEvents_.push_back({time, std::move(name)});
}

bool RunUpdates::silent() const { return wallClock() - lastSent_ > longestSilence; }

bool RunUpdates::send(double time, double begin)
{
    const bool goesOn = !callback_ || callback_({time, duration_, samples_, newEvents_, fields_});
    std::ranges::move(newEvents_, std::back_inserter(events_));
    newEvents_.clear();
    fields_.clear();
    samples_.time.clear();
    for (std::vector<double>& column : samples_.columns) column.clear();
    lastSent_ = wallClock();
    secondsOutside_ += lastSent_ - begin;
    return goesOn;
}

} // namespace touchdown
