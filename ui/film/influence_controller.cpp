// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/influence_controller.h"

#include <algorithm>
#include <utility>

namespace touchdown {

namespace {

constexpr int finestNodes = 193; // of a side: on coarser grids edges have large errors of their own

Case ofInfluence(const Case& c)
{
    Case solved = caseAt(attitudeCase(c), seriesOf(c).front());
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
        const SteadyResult state = steady(solved, [&](const SteadyProgress&) { return goOn(); });
        std::vector<PartInfluence> influence;
        if (state.status == SteadyStatus::Converged && !held) influence = shapeInfluence(solved, state, parts, goOn);
        mailbox_.post([&](Mail& mail) {
            mail.influence = std::move(influence);
            mail.finished = true;
            mail.stopped = !goOn();
        });
    });
}

void InfluenceController::deliver()
{
    const Mail mail = mailbox_.take();
    if (!mail.finished) return;
    end();
    if (!mail.stopped) emit found(mail.influence);
}

} // namespace touchdown
