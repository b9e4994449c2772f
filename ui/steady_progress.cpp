// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/steady_progress.h"

#include <QHBoxLayout>

#include "ui/quantity_format.h"

namespace touchdown {

namespace {

QString power(double value)
{
    return QLocale().toString(value, 'e', 1).replace(QLatin1Char('-'), QChar(0x2212));
}

} // namespace

SteadyProgressLine::SteadyProgressLine(QWidget* parent)
    : QWidget(parent), state_(new QLabel(tr("Ready"), this)), bar_(new QProgressBar(this)), text_(new QLabel(this))
{
    bar_->setRange(0, 0);
    bar_->setTextVisible(false);
    bar_->setFixedHeight(10);
    bar_->setFixedWidth(180);
    bar_->setAccessibleName(tr("Progress of the solution"));
    state_->setAccessibleName(tr("State of the solution"));
    text_->setAccessibleName(tr("Grid, iteration, residual and attitude"));
    text_->setMinimumWidth(1); // cut off rather than widening the window
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 2, 8, 2);
    layout->setSpacing(10);
    layout->addWidget(state_);
    layout->addWidget(bar_);
    layout->addWidget(text_, 1);
    bar_->hide();
}

void SteadyProgressLine::setState(SteadyController::State state)
{
    switch (state) {
    case SteadyController::State::Idle: break; // `end` says how
    case SteadyController::State::Running:
        state_->setText(tr("Solving"));
        text_->clear();
        break;
    case SteadyController::State::Stopping: state_->setText(tr("Stopping")); break;
    }
    bar_->setVisible(state != SteadyController::State::Idle);
}

void SteadyProgressLine::advance(const SteadyProgress& progress)
{
    text_->setText(tr("%1 · iteration %2 · residual %3 · load error %4 · height %5, pitch %6")
                       .arg(QString::fromStdString(progress.stage).replace(QStringLiteral(" x "), QStringLiteral(" × ")),
                            QString::number(progress.iteration), power(progress.residual), power(progress.loadError),
                            lengthText(progress.attitude.height, 4), readout(progress.attitude.pitch, "urad", 2)));
}

void SteadyProgressLine::end(const SteadyResult& result)
{
    switch (result.status) {
    case SteadyStatus::Converged: state_->setText(tr("Converged")); break;
    case SteadyStatus::NotConverged: state_->setText(tr("Not converged")); break;
    case SteadyStatus::Cancelled: state_->setText(tr("Stopped")); break;
    case SteadyStatus::Failed: state_->setText(tr("Failed")); break;
    }
    if (result.grid.x.empty()) text_->clear();
    else
        text_->setText(tr("%1 × %2 cells · %3 iterations · residual %4 · %5")
                           .arg(result.grid.nx())
                           .arg(result.grid.ny())
                           .arg(QLocale().toString(result.iterations), power(result.residual), timeText(result.wallSeconds)));
}

} // namespace touchdown
