// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/steady_progress.h"

#include <QLocale>

#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr double unknownShare = -1.0; // nobody knows how many iterations it takes

QString power(double value) { return QLocale().toString(value, 'e', 1).replace(QLatin1Char('-'), QChar(0x2212)); }

} // namespace

SteadyProgressLine::SteadyProgressLine(QWidget* parent)
    : ProgressStrip(tr("solution"), tr("Grid, iteration, residual and attitude"), parent)
{}

void SteadyProgressLine::setState(SteadyController::State state)
{
    follow(state, tr("Solving"));
    if (state == SteadyController::State::Running) ProgressStrip::advance(unknownShare, {});
}

void SteadyProgressLine::advance(const SteadyProgress& progress)
{
    const QString text =
        tr("%1 · iteration %2 · residual %3 · load error %4 · height %5, pitch %6")
            .arg(QString::fromStdString(progress.stage).replace(QStringLiteral(" x "), QStringLiteral(" × ")),
                 QString::number(progress.iteration), power(progress.residual), power(progress.loadError),
                 lengthText(progress.attitude.height, 4), readout(progress.attitude.pitch, "urad", 2));
    ProgressStrip::advance(unknownShare, text);
}

void SteadyProgressLine::end(const SteadyResult& result)
{
    const auto state = [&] {
        switch (result.status) {
        case SteadyStatus::Converged: return tr("Converged");
        case SteadyStatus::NotConverged: return tr("Not converged");
        case SteadyStatus::Cancelled: return tr("Stopped");
        case SteadyStatus::Failed: break;
        }
        return tr("Failed");
    };
    QString text;
    if (!result.grid.x.empty())
        text = tr("%1 × %2 cells · %3 iterations · residual %4 · %5")
                   .arg(result.grid.nx())
                   .arg(result.grid.ny())
                   .arg(QLocale().toString(result.iterations), power(result.residual), timeText(result.wallSeconds));
    conclude(state(), text);
}

} // namespace touchdown
