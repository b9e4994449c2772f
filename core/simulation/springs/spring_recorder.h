// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turns the accepted steps of the spring model into batches of samples. The ends of the steps, and where samples are
// far apart more points of a step's dense output, find the extremes between them.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/simulation/recording/run_recorder.h"
#include "core/simulation/springs/disk_under_springs.h"
#include "core/simulation/springs/spring_energy_balance.h"
#include "core/simulation/springs/spring_model.h"

namespace touchdown {

/// Takes the samples that a step passes from its dense output; hands them on in batches.
class SpringRecorder {
public:
    using State = SpringModel::State;
    using Mode = SpringModel::Mode;

    struct Point {
        double time = 0.0; // [s]
        State y;
        Mode mode;
        bool sample = false;
        bool smooth = false; // the same law has held since the point before
        void pass(auto& stream) { stream(time, y, mode, sample, smooth); }
    };

    /// Model and disk must last.
    SpringRecorder(const SpringModel& model, const DiskUnderSprings& disk, const Case& c, const RunCallback& callback,
                   const RunOptions& options = {});

    /// The start itself, unless the run continues.
    void begin(const State& y, Mode mode);
    /// For the integrator, see core/numerics/switched_system.h.
    bool isCheckpointDue(double time) const { return run_.isCheckpointDue(time); }
    template <class Pass>
    void sendCheckpoint(double time, bool extends, Pass&& passIntegration)
    {
        flush();
        if (!goOn_) return;
        if (!run_.sendCheckpoint(time, extends, [&](StateStream& stream) { passIntegration(stream), pass(stream); }))
            stop();
    }
    template <class Pass>
    void resume(Pass&& passIntegration)
    {
        if (from_) run_.resume(*from_, [&](StateStream& stream) { passIntegration(stream), pass(stream); });
    }
    /// Over a surface that moves, states have the time in them.
    template <class Y, class At>
    bool step(double t1, const Y& stateNow, Mode mode, At&& stateAt)
    {
        const State y1 = SpringModel::motionOf(stateNow);
        const auto at = [&](double t) { return SpringModel::motionOf(stateAt(t)); };
        const double t0 = last_.time, slack = slackAt(t1);
        const bool due = t1 - newest_ >= 0.1 * pointInterval_;
        const double most = interval_ > pointInterval_ ? double(mostParts) : 1.0;
        const int parts = due ? std::max(1, int(std::min((t1 - t0) / pointInterval_ + 0.5, most))) : 0;
        for (int k = 1; k <= std::max(parts, 1); ++k) {
            const double until = k < parts ? t0 + (t1 - t0) * k / parts : t1;
            for (; nextTime_ <= until + slack; nextTime_ = double(++index_) * interval_)
                if (!put({nextTime_, nextTime_ >= t1 - slack ? y1 : at(nextTime_), mode, true})) return false;
            if (k <= parts && until > newest_ + slack && !put({until, k < parts ? at(until) : y1, mode})) return false;
        }
        last_ = {t1, y1, mode};
        if (balance) {
            // The rate of a map's height has kinks within a step: shorter parts come closer to them.
            const int pieces = disk_.moves() ? 4 : 1;
            for (int k = 1; k < pieces; ++k) {
                const double inner = t0 + (t1 - t0) * k / pieces;
                balance->add(inner, at(inner), mode);
            }
            balance->add(t1, y1, mode);
        }
        if (++stepsSinceLook_ == stepsBetweenLooks) lookAtClock();
        return goOn_;
    }
    void event(double time, int guard, bool upper, Mode before, Mode after);
    /// After the last step: the last sample, where the run has ended, and what was not yet sent.
    void finish();

    /// The last state that can be trusted.
    const Point& last() const { return last_; }
    /// The time of the state that ended the run by failing, else of the last state [s].
    double endTime() const { return failedAt_.value_or(last_.time); }
    /// How the run ends when its samples say so.
    const RunEnd& end() const { return end_; }
    const RunRecorder& run() const { return run_; }
    /// Flying heights at the multiples of the sample interval; kept where the run is to be compared [m].
    const std::vector<double>& heights() const { return heights_; }
    void keepHeights() { keepsHeights_ = true; }
    /// When the front or rear spring was lost and has not come back; negative if it carries [s].
    double lostSince(int guard) const { return lostSince_[guard == SpringModel::Front ? 0 : 1]; }

    /// Kept from begin() on; may be null.
    SpringEnergyBalance* balance = nullptr;

private:
    static constexpr int stepsBetweenLooks = 1024;
    static constexpr int mostParts = 64; // of a step, for points
    bool put(const Point& point)
    {
        points_[filled_] = point;
        points_[filled_++].smooth = smooth_;
        smooth_ = true;
        newest_ = point.time;
        if (filled_ == points_.size()) flush();
        return goOn_;
    }
    /// By which times differ that are equal but for rounding [s].
    double slackAt(double time) const
    {
        return std::max(1e-9 * interval_, 4.0 * std::numeric_limits<double>::epsilon() * time);
    }
    void lookAtClock();
    void stop();
    void pass(StateStream& stream);
    /// Hands on the samples that were not yet sent.
    void flush();
    /// Records the points that are not yet recorded.
    void record();
    void send(double begin);
    /// Sets values_ to all quantities there.
    void observe(const Point& point) { model_.observe(point.y, point.mode, disk_.at(point.time), values_.data()); }
    /// Whether values_ are sane there; else the run ends.
    bool judge(const Point& point);

    const SpringModel& model_;
    const DiskUnderSprings& disk_;
    RunRecorder run_;
    std::vector<Point> points_;
    std::size_t filled_ = 0;
    std::shared_ptr<const RunCheckpoint> from_; // null: the run begins
    double interval_;                           // [s]
    double pointInterval_;                      // between points that find extremes [s]
    double newest_ = 0.0;                       // time of the newest point [s]
    double nextTime_ = 0.0;                     // of the next sample [s]
    long long index_ = 0;                       // of the next sample
    int stepsSinceLook_ = 0;
    bool goOn_ = true;
    bool smooth_ = true; // the same law holds since the newest point
    Point last_;
    Point lastSample_;               // the newest, which was looked at and sane
    std::optional<double> failedAt_; // [s]
    RunEnd end_;
    std::vector<double> values_;
    std::size_t energyColumn_;
    std::array<double, 2> lostSince_{-1.0, -1.0};
    std::size_t heightColumn_;
    bool keepsHeights_ = false;
    std::vector<double> heights_;
};

} // namespace touchdown
