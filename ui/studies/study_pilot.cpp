// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_pilot.h"

#include <cmath>
#include <exception>
#include <utility>

#include <QLocale>

namespace touchdown {

namespace {

/// A pilot ends as soon as it has done a good part, after some seconds that have done anything, or late.
constexpr double enoughSeconds = 1.0, enoughShare = 0.1, someSeconds = 3.0, longestPilot = 8.0; // [s], [-]

/// To one digit, to two below 20 of a unit: 1.4, 13, 20, 300.
double rounded(double value)
{
    const double unit = std::pow(10.0, std::floor(std::log10(value)));
    const double step = value / unit < 2.0 ? 0.1 * unit : unit;
    return step * std::round(value / step);
}

} // namespace

void StudyPilot::start(StudyPerformance perform, int jobs)
{
    begin([this, perform = std::move(perform), jobs, clock = clock_](const std::stop_token& stop) {
        const Estimate estimate = performPilot(perform, jobs, clock, stop);
        mailbox_.post([&](Mail& mail) { mail.estimate = estimate; });
    });
}

StudyPilot::Estimate StudyPilot::performPilot(const StudyPerformance& perform, int jobs,
                                              const std::function<double()>& clock, const std::stop_token& stop)
{
    const double begin = clock();
    double share = 0.0, seconds = 0.0;
    const auto watch = [&](const StudyProgress& progress) {
        share = progress.share;
        seconds = clock() - begin;
        const bool enough = seconds > longestPilot || (seconds > someSeconds && share > 0.0) ||
                            (seconds > enoughSeconds && share > enoughShare);
        return !enough && !stop.stop_requested();
    };
    try {
        const StudyReport report = perform(jobs, watch);
        if (report.status == StudyStatus::Failed) return {{}, true};
        if (report.status == StudyStatus::Completed) return {clock() - begin, false};
    } catch (const std::exception&) {
        return {{}, true};
    }
    return {share > 0.0 ? std::optional(seconds / share) : std::nullopt, false};
}

void StudyPilot::deliver()
{
    const Mail mail = mailbox_.take();
    if (!mail.estimate) return;
    const bool stopped = askedToStop(); // what it says is of a study that may have changed
    end();
    if (stopped) return;
    if (mail.estimate->failed)
        emit failed();
    else
        emit estimated(mail.estimate->seconds);
}

QString roughTime(double seconds)
{
    if (seconds < 1.0) return StudyPilot::tr("less than 1 s");
    const auto number = [](double value) { return QLocale().toString(rounded(value), 'g', 3); };
    if (seconds < 90.0) return StudyPilot::tr("about %1 s").arg(number(seconds));
    if (seconds < 90.0 * 60.0) return StudyPilot::tr("about %1 min").arg(number(seconds / 60.0));
    return StudyPilot::tr("about %1 h").arg(number(seconds / 3600.0));
}

} // namespace touchdown
