// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/steady_controller.h"

#include <exception>
#include <utility>

#include "core/simulation/static_state/steady_quantities.h"

namespace touchdown {

SteadyController::SteadyController(Solver solver, QObject* parent)
    : CalculationController(parent), solver_(std::move(solver))
{}

int SteadyController::start(Case c)
{
    return begin([this, c = std::move(c)](const std::stop_token& stop) {
        SteadyResult result;
        try {
            result = solver_(c, [&](const SteadyProgress& progress) {
                mailbox_.post([&](Mail& mail) { mail.progress = progress; });
                return !stop.stop_requested();
            });
        } catch (const std::exception& problem) {
            result = {};
            result.message = std::string("The calculation stopped with an error: ") + problem.what();
        }
        mailbox_.post([&](Mail& mail) { mail.result = std::move(result); });
    });
}

void SteadyController::deliver()
{
    const Mail mail = mailbox_.take();
    if (mail.progress) emit progressed(current(), progressOf(*mail.progress));
    if (!mail.result) return;
    end();
    emit finished(current(), *mail.result);
}

} // namespace touchdown
