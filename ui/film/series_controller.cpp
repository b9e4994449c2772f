// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/series_controller.h"

#include <exception>

#include "core/case/parameters.h"
#include "core/simulation/static_state/steady_quantities.h"

namespace touchdown {

SeriesController::SeriesController(SteadyController::Solver solver, QObject* parent)
    : CalculationController(parent), solver_(std::move(solver))
{}

int SeriesController::start(const Case& c, std::vector<SteadySeriesPoint> points)
{
    return begin([this, c, points = std::move(points)](const std::stop_token& stop) {
        for (std::size_t i = 0; i < points.size() && !stop.stop_requested(); ++i) {
            SteadyResult result = solveOne(caseAt(c, points[i]), i, points.size(), stop);
            if (result.status != SteadyStatus::Cancelled)
                mailbox_.post([&](Mail& mail) { mail.states.emplace_back(i, std::move(result)); });
        }
        mailbox_.post([&](Mail& mail) {
            mail.finished = true;
            mail.stopped = stop.stop_requested();
        });
    });
}

SteadyResult SeriesController::solveOne(const Case& c, std::size_t index, std::size_t count,
                                        const std::stop_token& stop)
{
    SteadyResult failed;
    if (const auto problems = checkCombinations(c); !problems.empty()) {
        failed.message = "the case contradicts itself: " + problems.front().key + " " + problems.front().message;
        return failed;
    }
    try {
        return solver_(c, [&](const SteadyProgress& update) {
            Progress progress = progressOf(update);
            progress.share = static_cast<double>(index) / static_cast<double>(count);
            progress.activity =
                "state " + std::to_string(index + 1) + " of " + std::to_string(count) + ", " + progress.activity;
            mailbox_.post([&](Mail& mail) { mail.progress = std::move(progress); });
            return !stop.stop_requested();
        });
    } catch (const std::exception& problem) {
        failed.message = std::string("The calculation stopped with an error: ") + problem.what();
        return failed;
    }
}

void SeriesController::deliver()
{
    const Mail mail = mailbox_.take();
    if (mail.progress) emit progressed(current(), *mail.progress);
    for (const auto& [index, result] : mail.states) emit solved(index, result);
    if (!mail.finished) return;
    end();
    emit finished(current(), mail.stopped);
}

} // namespace touchdown
