// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/shape_follower.h"

#include <algorithm>
#include <utility>

namespace touchdown {

namespace {

constexpr int mostNodes = 65; // of a side

} // namespace

ShapeFollower::ShapeFollower(SteadyController::Solver solver, QObject* parent)
    : QObject(parent), controller_(std::move(solver))
{
    connect(&controller_, &SteadyController::finished, this, [this](int number, const SteadyResult& result) {
        if (number == wanted_) emit followed(result);
        startNext();
    });
}

Case ShapeFollower::coarse(const Case& c)
{
    Case preview = c.steady.fixedAttitude ? c : attitudeCase(c);
    for (int& nodes : preview.film.nodes) nodes = std::min(nodes, mostNodes);
    preview.film.accuracy = 0.0;
    preview.steady.stiffness = preview.steady.sensitivities = preview.steady.allEquilibria = false;
    return caseAt(preview, seriesOf(preview).front());
}

void ShapeFollower::follow(const Case& c)
{
    waiting_ = coarse(c);
    if (!controller_.active()) startNext();
}

void ShapeFollower::forget()
{
    waiting_.reset();
    wanted_ = 0;
    controller_.stop();
}

void ShapeFollower::startNext()
{
    if (!waiting_) return;
    Case next = std::move(*waiting_);
    waiting_.reset();
    wanted_ = controller_.start(std::move(next));
}

} // namespace touchdown
