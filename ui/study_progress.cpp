// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study_progress.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>

#include "ui/quantity_format.h"

namespace touchdown {

namespace {

constexpr int barSteps = 1000;
constexpr double leastShare = 0.01, leastSeconds = 0.5; // before a guess is worth reading

} // namespace

QString timeLeftText(double share, double seconds)
{
    if (share < leastShare || seconds < leastSeconds) return {};
    const double left = seconds * (1.0 - share) / share;
    if (left < 1.0) return StudyProgressLine::tr("less than 1 s left");
    if (left < 99.5) return StudyProgressLine::tr("%1 s left").arg(std::lround(left));
    return StudyProgressLine::tr("%1 min left").arg(std::lround(left / 60.0));
}

StudyProgressLine::StudyProgressLine(QWidget* parent)
    : QWidget(parent), state_(new QLabel(tr("Ready"), this)), bar_(new QProgressBar(this)), text_(new QLabel(this))
{
    bar_->setRange(0, barSteps);
    bar_->setTextVisible(false);
    bar_->setFixedHeight(10);
    bar_->setFixedWidth(180);
    bar_->setAccessibleName(tr("Progress of the study"));
    state_->setAccessibleName(tr("State of the study"));
    text_->setAccessibleName(tr("Share, what is done now, time left"));
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

void StudyProgressLine::setState(StudyController::State state)
{
    switch (state) {
    case StudyController::State::Idle: break; // `end` says how
    case StudyController::State::Running:
        state_->setText(tr("Studying"));
        text_->clear();
        bar_->setValue(0);
        clock_.start();
        break;
    case StudyController::State::Stopping: state_->setText(tr("Stopping")); break;
    }
    bar_->setVisible(state != StudyController::State::Idle);
}

void StudyProgressLine::advance(double share, const QString& doing)
{
    share_ = std::clamp(share, 0.0, 1.0);
    bar_->setValue(static_cast<int>(std::lround(share_ * barSteps)));
    QStringList parts{tr("%1 %").arg(static_cast<int>(std::floor(100.0 * share_)))};
    if (!doing.isEmpty()) parts << doing;
    const QString left = timeLeftText(share_, static_cast<double>(clock_.elapsed()) * 1e-3);
    if (!left.isEmpty()) parts << left;
    text_->setText(parts.join(QStringLiteral(" · ")));
}

void StudyProgressLine::end(const StudyReport& report)
{
    switch (report.status) {
    case StudyStatus::Completed: state_->setText(tr("Completed")); break;
    case StudyStatus::Cancelled: state_->setText(tr("Stopped")); break;
    case StudyStatus::Failed: state_->setText(tr("Failed")); break;
    }
    text_->setText(tr("%1 · %2").arg(QString::fromStdString(report.title), timeText(report.wallSeconds)));
}

} // namespace touchdown
