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

/// Rails are quick and come first, then edge by edge.
std::vector<PartSelection> portions(const PartSelection& parts)
{
    std::vector<PartSelection> list(1);
    for (const SurfacePart& part : parts)
        if (part.kind == PartKind::Edge)
            list.push_back({part});
        else
            list.front().insert(part);
    return list;
}

} // namespace

void InfluenceController::start(const Case& c, const PartSelection& parts)
{
    stopAndWait(); // within one part
    begin([this, solved = ofInfluence(c), parts, held = c.steady.fixedAttitude](const std::stop_token& stop) {
        const auto goOn = [&] { return !stop.stop_requested(); };
        const SteadyResult state = steady(solved, [&](const SteadyProgress&) { return goOn(); });
        const bool flies = state.status == SteadyStatus::Converged && !held;
        std::vector<PartInfluence> influence;
        if (flies)
            for (const PartSelection& some : portions(parts)) {
                const std::vector<PartInfluence> more = shapeInfluence(solved, state, some, goOn);
                influence.insert(influence.end(), more.begin(), more.end());
                if (!goOn()) break;
                mailbox_.post([&](Mail& mail) { mail.influence = influence; });
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
