// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision/precision_pace.h"

#include <algorithm>
#include <numeric>

#include "core/studies/precision/precision_task.h"
#include "core/studies/runs/expected_cost.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

constexpr double knownShare = 0.02;                   // of the references that tells their pace
constexpr double passesOfStatic = 300.0;              // over the grid, of a static state
constexpr double springsPace = 1e-7, filmPace = 2e-7; // until the study's own runs tell it [s]

double costOf(const PrecisionTask& task, const Case& c)
{
    return task.inTime ? expectedCost(c) : passesOfStatic * c.film.nodes[0] * c.film.nodes[1];
}

std::vector<double> costsOfReferences(const PrecisionTask& task)
{
    std::vector<double> costs;
    for (const ReferenceCase& each : task.references) costs.push_back(costOf(task, each.c));
    return costs;
}

} // namespace

PrecisionPace::PrecisionPace(const PrecisionTask& task, int jobs, const std::vector<const Case*>& points)
    : timeLimit_(task.timeLimit),
      begin_(wallClock()),
      pace_(task.start.model == ModelKind::Springs ? springsPace : filmPace),
      references_(costsOfReferences(task))
{
    const std::vector<double> costs = costsOfReferences(task);
    const int threads = std::clamp(jobs, 1, std::max(1, static_cast<int>(costs.size())));
    referenceCost_ = std::accumulate(costs.begin(), costs.end(), 0.0) / threads;
    for (const Case* c : points) points_.push_back({costOf(task, *c), {}, task.repeats});
}

void PrecisionPace::beginPoint(std::size_t i)
{
    now_ = &points_[i];
    nowBegin_ = wallClock();
}

void PrecisionPace::endPoint()
{
    if (now_->seconds) --now_->repeats;
    now_->seconds = wallClock() - nowBegin_;
    now_ = nullptr;
    double cost = 0.0, seconds = 0.0;
    for (const Point& point : points_) {
        if (!point.seconds) continue;
        cost += point.cost;
        seconds += *point.seconds;
    }
    if (cost > 0.0) pace_ = seconds / cost;
}

void PrecisionPace::beginRepeats()
{
    for (Point& point : points_)
        if (!point.seconds) point = {0.0, 0.0, 0};
}

double PrecisionPace::left()
{
    double seconds = 0.0;
    if (atReferences_) {
        const double share = references_.share();
        if (share > knownShare && referenceCost_ > 0.0) pace_ = (wallClock() - begin_) / (share * referenceCost_);
        seconds += (1.0 - share) * referenceCost_ * pace_;
    }
    for (const Point& point : points_) {
        const double once = expected(point);
        if (!point.seconds) seconds += once;
        if (once <= timeLimit_) seconds += once * point.repeats;
    }
    if (now_ != nullptr) seconds -= std::min(wallClock() - nowBegin_, expected(*now_));
    return std::max(seconds, 0.0);
}

} // namespace touchdown
