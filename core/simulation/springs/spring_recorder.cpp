// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/springs/spring_recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/formats/units.h"

namespace touchdown {

SpringRecorder::SpringRecorder(const SpringModel& model, const DiskUnderSprings& disk, const Case& c,
                               const RunCallback& callback, const RunOptions& options)
    : model_(model),
      disk_(disk),
      run_(c, SpringModel::quantities(c), callback, options),
      points_(RunRecorder::samplesInBatch),
      from_(options.from),
      interval_(c.run.sampleInterval),
      pointInterval_(model.shortestPeriod() / 20.0),
      values_(run_.quantities().size()),
      energyColumn_(static_cast<std::size_t>(findQuantity(run_.quantities(), "energy"))),
      heightColumn_(static_cast<std::size_t>(findQuantity(run_.quantities(), "flying_height")))
{
    run_.moveOver(disk.recurrence());
}

void SpringRecorder::begin(const State& y, Mode mode)
{
    if (balance) balance->begin(y, mode);
    if (from_) return;
    last_ = lastSample_ = points_[0] = {0.0, y, mode, true};
    filled_ = 1;
    index_ = 1;
    nextTime_ = interval_;
}

void SpringRecorder::pass(StateStream& stream)
{
    stream(newest_, nextTime_, index_, smooth_, last_, lastSample_, lostSince_, heights_);
    if (balance) balance->pass(stream);
}

void SpringRecorder::event(double time, int guard, bool upper, Mode before, Mode after)
{
    if (guard != SpringModel::Pad) lostSince_[guard == SpringModel::Front ? 0 : 1] = upper ? -1.0 : time;
    run_.addEvent(time, model_.eventName(guard, before, after));
    // The forces may jump here: both sides count. rk4 switches within its next step.
    const bool ends = time <= last_.time;
    if (ends && time > newest_) put({time, last_.y, before});
    smooth_ = false;
    if (ends) put({time, last_.y, after});
}

void SpringRecorder::lookAtClock()
{
    stepsSinceLook_ = 0;
    if (run_.silent()) flush();
    run_.askForCheckpoint();
}

bool SpringRecorder::judge(const Point& point)
{
    const auto at = [&] { return " at " + fewDigitsOfTime(point.time, 4); };
    const bool finite = std::ranges::all_of(values_, [](double value) { return std::isfinite(value); });
    const double energy = values_[energyColumn_];
    if (!finite || energy > model_.energyBound()) {
        end_ = {RunStatus::Diverged, RunFailure::Diverged,
                "the motion diverged" + at() +
                    ": the energy grew beyond anything that the slider can store; use a smaller step or tolerance"};
    } else if (energy < -1e-12 * model_.energyBound()) {
        end_ = {RunStatus::Failed, RunFailure::NegativeEnergy,
                "the total energy became negative" + at() +
                    ": equation (5) of the paper as printed has no meaning where a spacing is negative; "
                    "springs.potential = \"held\" keeps it"};
    } else {
        return true;
    }
    goOn_ = false;
    failedAt_ = point.time;
    run_.dropEventsAfter(point.time);
    return false;
}

void SpringRecorder::record()
{
    for (std::size_t i = 0; i < filled_ && end_.completed(); ++i) {
        const Point& point = points_[i];
        observe(point);
        if (!point.sample) {
            run_.addPoint(point.time, values_, point.smooth);
            continue;
        }
        if (!judge(point)) break;
        lastSample_ = point;
        run_.addSample(point.time, values_, point.smooth);
        if (keepsHeights_) heights_.push_back(values_[heightColumn_]);
    }
    filled_ = 0;
    // The newest step ends beyond the newest sample, unless it is not yet recorded to its end.
    if (end_.completed() && last_.time > lastSample_.time) {
        observe(last_);
        judge(last_);
    }
    // Within a step, the newest sample is beyond the end of the step before.
    if (failedAt_ || lastSample_.time > last_.time) last_ = lastSample_;
}

void SpringRecorder::send(double begin)
{
    if (!run_.send(last_.time, begin)) stop();
}

void SpringRecorder::stop()
{
    if (!end_.completed()) return;
    end_ = {RunStatus::Cancelled, RunFailure::None, "stopped at " + fewDigitsOfTime(last_.time, 4)};
    goOn_ = false;
}

void SpringRecorder::flush()
{
    const double begin = wallClock();
    record();
    send(begin);
}

void SpringRecorder::finish()
{
    const double begin = wallClock();
    record();
    // The points after the newest sample of a run that failed are not good.
    if (!failedAt_) {
        observe(last_);
        run_.addLastSample(last_.time, values_, smooth_);
    }
    send(begin);
}

} // namespace touchdown
