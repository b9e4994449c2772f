// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run of any model reports: samples, events and fields in batches, sent before a silence becomes long; and the
// parts of the Summary that all models have in common.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/simulation/recording/field_snapshot.h"
#include "core/simulation/recording/run_checkpoint.h"
#include "core/simulation/recording/run_statistics.h"
#include "core/simulation/recording/sample_extremes.h"
#include "core/work/state_stream.h"
#include "core/work/wall_clock.h"

namespace touchdown {

/// How a run ends.
struct RunEnd {
    RunStatus status = RunStatus::Completed;
    RunFailure failure = RunFailure::None;
    std::string message{};
    bool completed() const { return status == RunStatus::Completed; }
};

class RunRecorder {
public:
    static constexpr std::size_t samplesInBatch = 1024;

    /// Case and callback must last.
    RunRecorder(const Case& c, std::vector<Quantity> quantities, const RunCallback& callback,
                const RunOptions& options = {});
    RunRecorder(const RunRecorder&) = delete;

    const std::vector<Quantity>& quantities() const { return quantities_; }
    /// Where a disk that is not flat moves: how often its surface comes again, before the first sample.
    void moveOver(const SurfaceRecurrence& surface) { statistics_.moveOver(surface); }
    /// A sample; `smooth`: the same law has held since the point or sample before. The last one is the end of the run.
    void addSample(double time, std::span<const double> values, bool smooth = true);
    /// The same, unless the newest sample is at this time.
    void addLastSample(double time, std::span<const double> values, bool smooth = true);
    /// A point of the motion between samples, for the extremes of the quantities. It counts once a sample follows.
    void addPoint(double time, std::span<const double> values, bool smooth = true)
    {
        extremes_.add(time, values, smooth);
    }
    /// The first 100 000 are kept.
    void addEvent(double time, std::string name);
    /// A run that failed at `time` has no events after it; those that were sent stay.
    void dropEventsAfter(double time);
    void addFields(FieldSnapshot snapshot) { fields_.push_back(std::move(snapshot)); }

    /// Whether it is time to send.
    bool full() const { return samples_.size() >= samplesInBatch; }
    bool silent() const;
    /// Sends what came since the last time, of a run that has reached `time`; false once somebody has stopped it. The
    /// caller's work for it since `begin` does not count as the solver's.
    bool send(double time, double begin = wallClock());
    /// Sends when it is time to, also within long solutions; false once somebody has stopped the run.
    bool lookAtClock(double time) { return stopped_ || !silent() ? !stopped_ : send(time); }
    bool stopped() const { return stopped_; }
    /// The values of the newest sample; empty without one.
    const std::vector<double>& newest() const { return newest_; }

    /// Whether a run that has reached `time` should send its state: each so many seconds of the clock, and a few times
    /// before its last tenth, from where a longer run can continue.
    bool isCheckpointDue(double time) const { return time >= nextCheckpoint_; }
    /// Looks at the clock.
    void askForCheckpoint();
    /// Sends what came since the last time, then the state at `time`, which pass(stream) names without this recorder;
    /// false once somebody has stopped the run. `extends`: the model's part does not depend on run.duration.
    template <class Pass>
    bool sendCheckpoint(double time, bool extends, Pass&& pass)
    {
        if (!send(time)) return false;
        const double begin = wallClock();
        StateStream stream;
        this->pass(stream);
        pass(stream);
        return sendState(time, extends, stream.take(), begin);
    }
    /// Before the first sample: continues from a state. Throws StateMisfit.
    template <class Pass>
    void resume(const RunCheckpoint& from, Pass&& pass)
    {
        StateStream stream(from.state);
        this->pass(stream);
        pass(stream);
        stream.end();
        setNextCheckpoint(from.time);
    }

    /// Wall time spent outside the solver [s].
    double secondsOutside() const { return secondsOutside_; }
    /// Wall time of the solver in the processes before, of a run that was continued [s].
    double solverSecondsBefore() const { return before_.wall - before_.outside; }
    /// Status, events, statistics, and the values of the newest sample as the final ones.
    Summary summary(const RunEnd& end, double endTime) const;
    /// Wall and solver time, since the construction.
    void setTimes(Summary& summary) const;

private:
    void pass(StateStream& stream);
    bool sendState(double time, bool extends, std::string state, double begin);
    void setNextCheckpoint(double time);

    std::vector<Quantity> quantities_;
    double duration_, interval_; // [s]
    const RunCallback& callback_;
    RunStatistics statistics_;
    SampleExtremes extremes_;
    SampleBatch samples_;
    double newestTime_ = 0.0;    // of the newest sample [s]
    std::vector<double> newest_; // its values
    std::vector<RunEvent> events_, newEvents_;
    std::size_t droppedEvents_ = 0;
    double firstDropped_ = 0.0; // [s]
    std::vector<FieldSnapshot> fields_;
    double begin_ = wallClock(), lastSent_ = begin_, secondsOutside_ = 0.0; // [s]
    std::optional<double> checkpointEach_;                                  // [s]
    double lastCheckpoint_ = begin_, checkpointCost_ = 0.0;                 // wall time [s]
    struct Seconds {
        double wall = 0.0, outside = 0.0; // [s]
    };
    Seconds before_; // of the processes before, of a run that was continued
    double nextCheckpoint_ = std::numeric_limits<double>::infinity(); // of the run [s]
    bool stopped_ = false;
};

} // namespace touchdown
