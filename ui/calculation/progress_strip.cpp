// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calculation/progress_strip.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>

namespace touchdown {

namespace {

constexpr int barSteps = 1000;

} // namespace

ProgressStrip::ProgressStrip(const QString& what, const QString& told, QWidget* parent)
    : QWidget(parent), state_(new QLabel(tr("Ready"), this)), bar_(new QProgressBar(this)), text_(new QLabel(this))
{
    bar_->setTextVisible(false);
    bar_->setFixedHeight(10);
    bar_->setFixedWidth(180);
    bar_->setAccessibleName(tr("Progress of the %1").arg(what));
    state_->setAccessibleName(tr("State of the %1").arg(what));
    text_->setAccessibleName(told);
    text_->setTextFormat(Qt::PlainText);
    text_->setMinimumWidth(1); // cut off rather than widening the window
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 2, 8, 2);
    layout->setSpacing(10);
    layout->addWidget(state_);
    layout->addWidget(bar_);
    layout->addWidget(text_, 1);
    bar_->hide();
}

void ProgressStrip::follow(CalculationController::State state, const QString& running)
{
    if (state == CalculationController::State::Running)
        begin(running);
    else if (state == CalculationController::State::Stopping)
        state_->setText(tr("Stopping"));
    else
        bar_->hide();
}

void ProgressStrip::begin(const QString& state)
{
    state_->setText(state);
    text_->clear();
    bar_->setRange(0, barSteps);
    bar_->setValue(0);
    bar_->show();
}

void ProgressStrip::advance(double share, const QString& text)
{
    bar_->setRange(0, share < 0.0 ? 0 : barSteps);
    if (share >= 0.0) bar_->setValue(static_cast<int>(std::lround(std::min(1.0, share) * barSteps)));
    text_->setText(text);
}

void ProgressStrip::conclude(const QString& state, const QString& text)
{
    bar_->hide();
    state_->setText(state);
    text_->setText(text);
}

} // namespace touchdown
