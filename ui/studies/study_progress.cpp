// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_progress.h"

#include <algorithm>
#include <cmath>

#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

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
    : ProgressStrip(tr("study"), tr("Share, what is done now, time left"), parent)
{}

void StudyProgressLine::setState(StudyController::State state)
{
    follow(state, tr("Studying"));
    if (state == StudyController::State::Running) clock_.start();
}

void StudyProgressLine::advance(double share, const QString& doing)
{
    const double done = std::clamp(share, 0.0, 1.0);
    QStringList parts{tr("%1 %").arg(static_cast<int>(std::floor(100.0 * done)))};
    if (!doing.isEmpty()) parts << doing;
    const QString left = timeLeftText(done, static_cast<double>(clock_.elapsed()) * 1e-3);
    if (!left.isEmpty()) parts << left;
    ProgressStrip::advance(done, parts.join(QStringLiteral(" · ")));
}

void StudyProgressLine::end(const StudyReport& report)
{
    const auto state = [&] {
        switch (report.status) {
        case StudyStatus::Completed: return tr("Completed");
        case StudyStatus::Cancelled: return tr("Stopped");
        case StudyStatus::Failed: break;
        }
        return tr("Failed");
    };
    conclude(state(), tr("%1 · %2").arg(QString::fromStdString(report.title), timeText(report.wallSeconds)));
}

} // namespace touchdown
