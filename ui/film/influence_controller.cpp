// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/influence_controller.h"

#include "core/simulation/static_state/contact_rest.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace touchdown {

namespace {

constexpr int finestNodes = 193; // of a side: on coarser grids edges have large errors of their own

Case ofInfluence(const Case& c)
{
    Case solved = withoutSeries(attitudeCase(c));
    for (int& nodes : solved.film.nodes) nodes = std::min(nodes, finestNodes);
    solved.film.accuracy = 0.0;
    return solved;
}

} // namespace

void InfluenceController::start(const Case& c, const PartSelection& parts)
{
    stopAndWait(); // within one part
    begin([this, solved = ofInfluence(c), parts, held = c.steady.fixedAttitude](const std::stop_token& stop) {
        const auto goOn = [&] { return !stop.stop_requested(); };
        bool flies = false;
        try {
            const SteadyResult state = steadyWithContact(solved, [&](const SteadyProgress&) { return goOn(); });
            flies = state.status == SteadyStatus::Converged && !held;
            std::vector<PartInfluence> influence;
            if (flies)
                shapeInfluence(solved, state, parts, [&](const PartInfluence* found) {
                    if (found) influence.push_back(*found);
                    if (found && goOn()) mailbox_.post([&](Mail& mail) { mail.influence = influence; });
                    return goOn();
                });
        } catch (const std::exception&) {
            flies = false; // as where memory is short: nothing is known
        }
        mailbox_.post([&](Mail& mail) {
            if (!flies) mail.influence.emplace();
            mail.finished = true;
            mail.stopped = !goOn();
        });
    });
}

void InfluenceController::deliver()
{
    const Mail mail = mailbox_.take();
    if (mail.finished) end();
    if (mail.influence && !mail.stopped && state() != State::Stopping) emit found(*mail.influence);
}

} // namespace touchdown
