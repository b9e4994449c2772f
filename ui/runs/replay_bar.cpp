// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/replay_bar.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QEvent>
#include <QHBoxLayout>

#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr int replaySteps = 1000;
constexpr int replayFrame = 16; // [ms]

} // namespace

ReplayBar::ReplayBar(std::function<std::optional<PlotRange>()> span, QWidget* parent)
    : QWidget(parent),
      span_(std::move(span)),
      button_(new QToolButton(this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      time_(new QLabel(this)),
      speed_(new QLabel(this))
{
    timer_.setInterval(replayFrame);
    button_->setAutoRaise(true);
    button_->setFocusPolicy(Qt::StrongFocus);
    button_->setToolTip(tr("Replay in slow motion what the plots show; zoom there to replay less"));
    slider_->setRange(0, replaySteps);
    slider_->setValue(replaySteps);
    slider_->setPageStep(replaySteps / 20);
    slider_->setAccessibleName(tr("Time of the replay"));
    time_->setMinimumWidth(time_->fontMetrics().horizontalAdvance(timeText(-888.8e-6)));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 2, 12, 4);
    layout->addWidget(button_);
    layout->addWidget(slider_, 1);
    layout->addWidget(time_);
    layout->addWidget(speed_);
    connect(button_, &QToolButton::clicked, this, [this] { setPlaying(!playing()); });
    connect(slider_, &QSlider::valueChanged, this, [this](int value) {
        setPlaying(false);
        choose(double(value) / replaySteps);
    });
    connect(&timer_, &QTimer::timeout, this, [this] { advance(1e-9 * static_cast<double>(clock_.nsecsElapsed())); });
    describe();
}

void ReplayBar::setPlaying(bool playing)
{
    if (playing == timer_.isActive()) return;
    if (playing && !span_()) return;
    if (playing) {
        if (share_ >= 1.0) choose(0.0);
        clock_.start();
        timer_.start();
    } else {
        timer_.stop();
    }
    describe();
}

void ReplayBar::advance(double seconds)
{
    clock_.start();
    choose(std::min(1.0, share_ + seconds / passSeconds));
    if (share_ >= 1.0) setPlaying(false);
}

void ReplayBar::choose(double share)
{
    share_ = share;
    if (const auto span = span_()) emit timeChosen(span->low + share * span->width());
}

void ReplayBar::showTime(const std::optional<double>& time)
{
    const auto span = span_();
    speed_->setText(span ? tr("%1 per second").arg(timeText(span->width() / passSeconds)) : QString());
    if (!span) return time_->clear();
    const double at = std::clamp(time.value_or(span->high), span->low, span->high);
    // A pass continues from its own place: the pictures may stand at a sample beside it.
    if (!playing()) share_ = span->width() > 0.0 ? (at - span->low) / span->width() : 1.0;
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(std::lround(share_ * replaySteps)));
    time_->setText(time ? timeText(at) : QString()); // else the picture shows the newest sample
}

void ReplayBar::describe()
{
    button_->setIcon(icon(playing() ? QStringLiteral("pause") : QStringLiteral("run"), palette()));
    button_->setAccessibleName(playing() ? tr("Pause the replay") : tr("Replay the run"));
}

void ReplayBar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) describe();
}

void ReplayBar::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    setPlaying(false);
}

} // namespace touchdown
