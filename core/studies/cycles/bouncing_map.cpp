// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/bouncing_map.h"

#include <cmath>

#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/physics/contact/ono_yamane.h"

namespace touchdown {

namespace {

constexpr int linePoints = 101; // of the line W = 0
constexpr int halvings = 60;

/// The case of a cell, or why there is none.
std::optional<Case> caseAt(const BouncingMapTask& task, double x, double y, std::string& problem)
{
    Case c = task.start;
    for (const auto& [axis, value] : {std::pair(&task.x, x), std::pair(&task.y, y)})
        if (const auto wrong = setFromNumber(c, axis->keys, value)) {
            problem = axis->keys.key + ": " + *wrong;
            return {};
        }
    for (const CaseProblem& wrong : checkCombinations(c)) {
        problem = wrong.key + ": " + wrong.message;
        return {};
    }
    return c;
}

std::optional<double> workAt(const BouncingMapTask& task, double x, double y)
{
    std::string problem;
    const std::optional<Case> c = caseAt(task, x, y, problem);
    if (!c) return {};
    return cycleWork(*c);
}

/// The first value of the axis at which the function changes its sign, by bisection between its neighbours.
std::optional<double> zeroAlong(const BouncingMapAxis& axis, const std::function<std::optional<double>(double)>& work)
{
    for (std::size_t i = 1; i < axis.values.size(); ++i) {
        double low = axis.values[i - 1], high = axis.values[i];
        const std::optional<double> before = work(low), after = work(high);
        if (!before || !after || (*before < 0.0) == (*after < 0.0)) continue;
        for (int k = 0; k < halvings; ++k) {
            const double middle = 0.5 * (low + high);
            const std::optional<double> there = work(middle);
            if (!there) return {};
            ((*there < 0.0) == (*before < 0.0) ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }
    return {};
}

} // namespace

double BouncingMapAxis::at(double share) const
{
    const double first = values.front(), last = values.back();
    return logarithmic ? first * std::pow(last / first, share) : std::lerp(first, last, share);
}

MapClass MapCell::kind() const
{
    if (runs(BouncingEnd::Bounces) > 0) return MapClass::Bounces;
    if (runs(BouncingEnd::Failed) > 0) return MapClass::Fails;
    if (runs(BouncingEnd::Unknown) > 0) return MapClass::Unknown;
    if (runs(BouncingEnd::Caught) == 0) return MapClass::Flies;
    return runs(BouncingEnd::Flies) == 0 ? MapClass::Caught : MapClass::FliesOrCaught;
}

MapCount countOf(const std::vector<MapCell>& cells)
{
    MapCount count;
    for (const MapCell& cell : cells) {
        if (!cell.done) continue;
        ++count.cells;
        const bool creates = cell.cycleWork < 0.0;
        const MapClass kind = cell.kind();
        if (kind == MapClass::Bounces)
            ++(creates ? count.creating : count.taking);
        else if (kind != MapClass::Fails && kind != MapClass::Unknown && creates)
            ++(kind == MapClass::Flies ? count.quietFlying : count.quietOther);
    }
    return count;
}

MapCell judgeCell(const BouncingMapTask& task, double x, double y, const std::function<bool()>& goOn)
{
    MapCell cell{.x = x, .y = y};
    const std::optional<Case> c = caseAt(task, x, y, cell.problem);
    cell.done = true;
    if (!c) {
        cell.ends[static_cast<std::size_t>(BouncingEnd::Failed)] = task.starts;
        return cell;
    }
    cell.cycleWork = cycleWork(*c).value_or(0.0);
    BouncingSearch search = task.search;
    search.mostCrossings = 0;
    search.goOn = goOn;
    for (int k = 0; k < task.starts; ++k) {
        const BouncingRun run = runOf(task.sliderOf, *c, k, x, search);
        cell.done = cell.done && (!goOn || goOn());
        if (!cell.done) return cell;
        if (run.end == BouncingEnd::Failed) cell.problem = run.problem;
        ++cell.ends[static_cast<std::size_t>(run.end)];
    }
    return cell;
}

std::vector<std::pair<double, double>> zeroWork(const BouncingMapTask& task)
{
    std::vector<std::pair<double, double>> alongY, alongX;
    for (int i = 0; i < linePoints; ++i) {
        const double x = task.x.at(double(i) / (linePoints - 1)), y = task.y.at(double(i) / (linePoints - 1));
        if (const auto zero = zeroAlong(task.x, [&](double value) { return workAt(task, value, y); }))
            alongY.emplace_back(*zero, y);
        if (const auto zero = zeroAlong(task.y, [&](double value) { return workAt(task, x, value); }))
            alongX.emplace_back(x, *zero);
    }
    return alongX.size() > alongY.size() ? alongX : alongY;
}

} // namespace touchdown
