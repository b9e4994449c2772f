// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/run_recorder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/formats/units.h"

namespace touchdown {

namespace {

constexpr double longestSilence = 0.015; // [s]
constexpr double sameTime = 1e-6;        // less than this is rounding, of the sample interval [-]
constexpr std::size_t mostEvents = 100'000;

} // namespace

RunRecorder::RunRecorder(const Case& c, std::vector<Quantity> quantities, const RunCallback& callback)
    : quantities_(std::move(quantities)),
      duration_(c.run.duration),
      interval_(c.run.sampleInterval),
      callback_(callback),
      statistics_(c, quantities_),
      extremes_(quantities_.size())
{
    samples_.time.reserve(samplesInBatch);
    samples_.columns.resize(quantities_.size());
    for (std::vector<double>& column : samples_.columns) column.reserve(samplesInBatch);
}

void RunRecorder::addSample(double time, std::span<const double> values, bool smooth)
{
    samples_.time.push_back(time);
    for (std::size_t i = 0; i < values.size(); ++i) samples_.columns[i].push_back(values[i]);
    extremes_.add(time, values, smooth);
    statistics_.addSample(time, values, extremes_.least(), extremes_.most());
    extremes_.restart();
    newestTime_ = time;
    newest_.assign(values.begin(), values.end());
}

void RunRecorder::addLastSample(double time, std::span<const double> values, bool smooth)
{
    if (time - newestTime_ > sameTime * interval_) addSample(time, values, smooth);
}

void RunRecorder::addEvent(double time, std::string name)
{
    if (events_.size() + newEvents_.size() < mostEvents)
        newEvents_.push_back({time, std::move(name)});
    else if (droppedEvents_++ == 0)
        firstDropped_ = time;
}

void RunRecorder::dropEventsAfter(double time)
{
    std::erase_if(newEvents_, [time](const RunEvent& event) { return event.time > time; });
}

bool RunRecorder::silent() const { return wallClock() - lastSent_ > longestSilence; }

bool RunRecorder::send(double time, double begin)
{
    if (callback_ && !callback_({time, duration_, samples_, newEvents_, fields_})) stopped_ = true;
    std::ranges::move(newEvents_, std::back_inserter(events_));
    newEvents_.clear();
    fields_.clear();
    samples_.time.clear();
    for (std::vector<double>& column : samples_.columns) column.clear();
    lastSent_ = wallClock();
    secondsOutside_ += lastSent_ - begin;
    return !stopped_;
}

Summary RunRecorder::summary(const RunEnd& end, double endTime) const
{
    Summary summary;
    summary.status = end.status;
    summary.failure = end.failure;
    summary.message = end.message;
    summary.endTime = endTime;
    summary.events = events_;
    for (std::size_t i = 0; i < newest_.size(); ++i)
        if (std::isfinite(newest_[i])) summary.final.emplace_back(quantities_[i].name, newest_[i]);
    if (droppedEvents_ > 0)
        summary.warnings.push_back("only the first " + std::to_string(mostEvents) +
                                   " switches are listed and counted; there are " + std::to_string(droppedEvents_) +
                                   " more after " + fewDigits(firstDropped_, "ms", 4));
    statistics_.finish(summary);
    return summary;
}

void RunRecorder::setTimes(Summary& summary) const
{
    summary.wallSeconds = wallClock() - begin_;
    summary.solverSeconds = summary.wallSeconds - secondsOutside_;
}

} // namespace touchdown
