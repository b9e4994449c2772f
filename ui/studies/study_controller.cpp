// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_controller.h"

#include <exception>

namespace touchdown {

int StudyController::start(StudyPerformance perform, int jobs)
{
    return begin(
        [this, perform = std::move(perform), jobs](const std::stop_token& stop) { work(perform, jobs, stop); });
}

void StudyController::work(const StudyPerformance& perform, int jobs, const std::stop_token& stop)
{
    StudyReport report;
    try {
        report = perform(jobs, [&](const StudyProgress& progress) {
            Progress now{progress.share, progress.doing, {}};
            std::optional<StudyReport> soFar; // copied before the mailbox is locked
            if (progress.soFar) soFar = *progress.soFar;
            mailbox_.post([&](Mail& mail) {
                mail.progress = std::move(now);
                if (soFar) mail.partial = std::move(soFar);
            });
            return !stop.stop_requested();
        });
    } catch (const std::exception& problem) {
        report = {};
        report.status = StudyStatus::Failed;
        report.message = std::string("The study stopped with an error: ") + problem.what();
    }
    mailbox_.post([&](Mail& mail) { mail.report = std::move(report); });
}

void StudyController::deliver()
{
    const Mail mail = mailbox_.take();
    if (mail.progress) emit progressed(current(), *mail.progress);
    if (mail.partial && !mail.report) emit partial(current(), *mail.partial);
    if (!mail.report) return;
    end();
    emit finished(current(), *mail.report);
}

} // namespace touchdown
