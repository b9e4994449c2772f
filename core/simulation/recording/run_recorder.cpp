// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/run_recorder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/formats/units.h"

namespace touchdown {

namespace {

constexpr double longestSilence = 0.015; // [s]
constexpr double sameTime = 1e-6;        // less than this is rounding, of the sample interval [-]
constexpr std::size_t mostEvents = 100'000;
constexpr double leastBetween = 20.0; // of the cost of a checkpoint, until the next one
// Of the run, where it should send its state, so that there is one before the last tenth, which a longer run has
// elsewhere.
constexpr std::array stations{0.5, 0.7, 0.85};
constexpr double tail = 0.9;

} // namespace

RunRecorder::RunRecorder(const Case& c, std::vector<Quantity> quantities, const RunCallback& callback,
                         const RunOptions& options)
    : quantities_(std::move(quantities)),
      duration_(c.run.duration),
      interval_(c.run.sampleInterval),
      callback_(callback),
      statistics_(c, quantities_),
      extremes_(quantities_.size()),
      checkpointEach_(options.checkpointEach)
{
    setNextCheckpoint(0.0);
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

void RunRecorder::setNextCheckpoint(double time)
{
    nextCheckpoint_ = std::numeric_limits<double>::infinity();
    if (!checkpointEach_) return;
    const auto next = std::ranges::find_if(stations, [&](double share) { return share * duration_ > time; });
    if (next != stations.end()) nextCheckpoint_ = *next * duration_;
}

void RunRecorder::askForCheckpoint()
{
    if (checkpointEach_ && wallClock() - lastCheckpoint_ >= std::max(*checkpointEach_, leastBetween * checkpointCost_))
        nextCheckpoint_ = 0.0;
}

bool RunRecorder::sendState(double time, bool extends, std::string state, double begin)
{
    checkpointCost_ = wallClock() - begin; // without the callback, which may wait for a person
    // The samples of the last tenth count otherwise than those before, and that is where the run ends.
    const RunCheckpoint checkpoint{time, extends && time < tail * duration_ - interval_, std::move(state)};
    if (callback_ && !callback_({time, duration_, samples_, newEvents_, fields_, &checkpoint})) stopped_ = true;
    lastSent_ = lastCheckpoint_ = wallClock();
    secondsOutside_ += lastCheckpoint_ - begin;
    setNextCheckpoint(time);
    return !stopped_;
}

void RunRecorder::pass(StateStream& stream)
{
    Seconds soFar{before_.wall + wallClock() - begin_, before_.outside + secondsOutside_};
    stream(soFar, statistics_, extremes_, newestTime_, newest_, events_, droppedEvents_, firstDropped_);
    StateStream::require(newest_.empty() || newest_.size() == quantities_.size());
    if (stream.reads()) before_ = soFar;
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
    summary.wallSeconds = before_.wall + wallClock() - begin_;
    summary.solverSeconds = summary.wallSeconds - before_.outside - secondsOutside_;
}

} // namespace touchdown
