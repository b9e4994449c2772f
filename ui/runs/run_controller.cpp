// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_controller.h"

#include <utility>

#include "core/simulation/run.h"
#include "ui/runs/run_worker.h"

namespace touchdown {

RunController::RunController(QObject* parent)
    : RunController([](const Case& c, const RunCallback& callback) { return run(c, callback); }, parent)
{}

RunController::RunController(Solver solver, QObject* parent) : CalculationController(parent), solver_(std::move(solver))
{}

int RunController::start(RunRequest request)
{
    stopAndWait();
    pace_.reset();
    return begin([this, request = std::move(request)](const std::stop_token& stop) {
        RunWorker(solver_, request, pace_, mailbox_, stop).work();
    });
}

void RunController::pause()
{
    if (setPaused(true)) pace_.setPaused(true);
}

void RunController::resume()
{
    if (setPaused(false)) pace_.setPaused(false);
}

void RunController::step()
{
    if (state() == State::Paused) pace_.step();
}

void RunController::deliver()
{
    RunMail mail = mailbox_.take();
    mail.delivery.run = current();
    if (!mail.recordingProblem.empty()) emit recordingFailed(current(), QString::fromStdString(mail.recordingProblem));
    emit delivered(mail.delivery);
    if (mail.delivery.duration > 0.0)
        emit progressed(current(), runProgress(mail.delivery.time, mail.delivery.duration));
    // A solver that waits for room gets it at once: the plots draw at their own rate.
    setInterval(mail.wasFull ? 0 : shortestInterval);
    if (!mail.summary) return;
    end();
    emit finished(current(), *mail.summary);
}

} // namespace touchdown
