// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_progress.h"

#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr qint64 rateInterval = 250; // [ms] between estimates
constexpr double newShare = 0.4;     // of a new estimate in the smoothed rate

} // namespace

RunProgress::RunProgress(QWidget* parent) : ProgressStrip(tr("run"), tr("Simulated time, rate and time left"), parent)
{}

void RunProgress::begin()
{
    clock_.start();
    time_ = duration_ = rate_ = rateTime_ = 0.0;
    ProgressStrip::begin(stateText(RunController::State::Running));
}

void RunProgress::setState(RunController::State state)
{
    runState_ = state;
    if (state != RunController::State::Idle) setStateText(stateText(state));
    if (state == RunController::State::Running) {
        clock_.restart();
        rateTime_ = time_;
        rate_ = 0.0;
    }
    updateText();
}

void RunProgress::advance(double time, double duration)
{
    time_ = time;
    duration_ = duration;
    if (clock_.isValid() && clock_.elapsed() >= rateInterval) {
        const double now = (time - rateTime_) / (static_cast<double>(clock_.restart()) * 1e-3);
        rate_ = rate_ > 0.0 ? (1.0 - newShare) * rate_ + newShare * now : now;
        rateTime_ = time;
    }
    updateText();
}

void RunProgress::end(const Summary& summary)
{
    rate_ = 0.0;
    const auto state = [&] {
        switch (summary.status) {
        case RunStatus::Completed: return tr("Completed");
        case RunStatus::Cancelled: return tr("Stopped");
        case RunStatus::Diverged: return tr("Diverged");
        case RunStatus::Failed: break;
        }
        return tr("Failed");
    };
    conclude(state(), tr("%1 simulated · %L2 steps · solver %3")
                          .arg(timeText(summary.endTime))
                          .arg(summary.steps)
                          .arg(timeText(summary.solverSeconds)));
}

QString RunProgress::stateText(RunController::State state) const
{
    switch (state) {
    case RunController::State::Running: return tr("Running");
    case RunController::State::Paused: return tr("Paused");
    case RunController::State::Stopping: return tr("Stopping");
    case RunController::State::Idle: break;
    }
    return tr("Ready");
}

void RunProgress::updateText()
{
    if (runState_ == RunController::State::Idle || duration_ <= 0.0) return;
    QString text = tr("%1 of %2").arg(timeText(time_), timeText(duration_));
    // A film begins with its static state.
    if (time_ <= 0.0 && runState_ == RunController::State::Running) text += tr(" · preparing");
    if (rate_ > 0.0 && runState_ == RunController::State::Running) {
        text += tr(" · %1 per second").arg(timeText(rate_));
        text += tr(" · %1 left").arg(timeText((duration_ - time_) / rate_));
    }
    ProgressStrip::advance(time_ / duration_, text);
}

} // namespace touchdown
