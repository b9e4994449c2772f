// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/shape_follower.h"

#include <algorithm>
#include <utility>

namespace touchdown {

namespace {

constexpr int mostNodes = 65; // of a side

} // namespace

ShapeFollower::ShapeFollower(Solver solver, QObject* parent)
    : QObject(parent), controller_([this, solver = std::move(solver)](const Case& c, const SteadyCallback& callback) {
          return solver(c, before_, from_, callback);
      })
{
    connect(&controller_, &SteadyController::finished, this, [this](int number, const SteadyResult& result) {
        if (number == wanted_) {
            wanted_ = 0;
            if (result.status == SteadyStatus::Converged) {
                before_ = solving_;
                from_ = result;
            }
            emit followed(result);
        } else {
            from_ = {};
        }
        startNext();
    });
}

Case ShapeFollower::coarse(const Case& c)
{
    Case preview = c.steady.fixedAttitude ? c : attitudeCase(c);
    for (int& nodes : preview.film.nodes) nodes = std::min(nodes, mostNodes);
    preview.film.accuracy = 0.0;
    preview.steady.stiffness = preview.steady.sensitivities = preview.steady.allEquilibria = false;
    return withoutSeries(std::move(preview));
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
    solving_ = std::move(*waiting_);
    waiting_.reset();
    wanted_ = controller_.start(solving_);
}

} // namespace touchdown
