// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run_progress.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>

#include "ui/quantity_format.h"

namespace touchdown {

namespace {

constexpr int barSteps = 1000;
constexpr qint64 rateInterval = 250; // [ms] between estimates
constexpr double newShare = 0.4;     // of a new estimate in the smoothed rate

} // namespace

RunProgress::RunProgress(QWidget* parent)
    : QWidget(parent), state_(new QLabel(tr("Ready"), this)), bar_(new QProgressBar(this)), text_(new QLabel(this))
{
    bar_->setRange(0, barSteps);
    bar_->setTextVisible(false);
    bar_->setFixedHeight(10);
    bar_->setFixedWidth(180);
    bar_->setAccessibleName(tr("Progress of the run"));
    state_->setAccessibleName(tr("State of the run"));
    text_->setAccessibleName(tr("Simulated time, rate and time left"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 2, 8, 2);
    layout->setSpacing(10);
    layout->addWidget(state_);
    layout->addWidget(bar_);
    layout->addWidget(text_, 1);
    bar_->hide();
}

void RunProgress::begin()
{
    clock_.start();
    time_ = rate_ = rateTime_ = 0.0;
    bar_->setValue(0);
    bar_->show();
    text_->clear();
}

void RunProgress::setState(RunController::State state)
{
    runState_ = state;
    if (state != RunController::State::Idle) state_->setText(stateText(state));
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
    if (duration > 0.0) bar_->setValue(static_cast<int>(std::lround(std::min(1.0, time / duration) * barSteps)));
    if (clock_.isValid() && clock_.elapsed() >= rateInterval) {
        const double now = (time - rateTime_) / (static_cast<double>(clock_.restart()) * 1e-3);
        rate_ = rate_ > 0.0 ? (1.0 - newShare) * rate_ + newShare * now : now;
        rateTime_ = time;
    }
    updateText();
}

void RunProgress::end(const Summary& summary)
{
    bar_->hide();
    rate_ = 0.0;
    switch (summary.status) {
    case RunStatus::Completed: state_->setText(tr("Completed")); break;
    case RunStatus::Cancelled: state_->setText(tr("Stopped")); break;
    case RunStatus::Diverged: state_->setText(tr("Diverged")); break;
    case RunStatus::Failed: state_->setText(tr("Failed")); break;
    }
    text_->setText(tr("%1 simulated · %L2 steps · solver %3")
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
    text_->setText(text);
}

} // namespace touchdown
