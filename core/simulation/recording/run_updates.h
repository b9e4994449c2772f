// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run tells while it goes: its samples, events and fields, a batch at a time and before a silence becomes long.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/numerics/wall_clock.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

class RunUpdates {
public:
    static constexpr std::size_t samplesInBatch = 1024;

    /// The callback must last.
    RunUpdates(std::size_t quantities, double duration, const RunCallback& callback);

    void addSample(double time, std::span<const double> values);
    /// The first 100 000 are kept.
    void addEvent(double time, std::string name);
    void addFields(FieldSnapshot snapshot) { fields_.push_back(std::move(snapshot)); }

    /// Whether it is time to send.
    bool full() const { return samples_.size() >= samplesInBatch; }
    bool silent() const;
    /// What is sent next.
    const SampleBatch& samples() const { return samples_; }
    /// Sends what came since the last time, of a run that has come to `time`; false when somebody stops it. What the
    /// caller does for it since `begin` is no work of its solver.
    bool send(double time, double begin = wallClock());

    const std::vector<RunEvent>& events() const { return events_; }
    /// Wall time spent outside the solver [s].
    double secondsOutside() const { return secondsOutside_; }

private:
    double duration_; // [s]
    const RunCallback& callback_;
    SampleBatch samples_;
    std::vector<RunEvent> events_, newEvents_;
    std::vector<FieldSnapshot> fields_;
    double lastSent_ = wallClock(), secondsOutside_ = 0.0; // [s]
};

} // namespace touchdown
