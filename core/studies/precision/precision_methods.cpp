// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision/precision_methods.h"

#include <algorithm>
#include <cmath>

#include "core/case/fields.h"
#include "core/numerics/cvode.h"
#include "core/studies/study/few_digits.h"

namespace touchdown {

namespace {

constexpr double mostSteps = 1e7; // of a method's finest run
constexpr double fewestReferenceSteps = 4e6, mostReferenceSteps = 4e7;
constexpr std::size_t mostOfSeries = 13; // 1, 2, 5, 10 ..: four decades

/// 1, 2, 5 times a power of ten, from coarse to fine.
std::vector<std::string> stepSeries(double duration)
{
    const double least = duration / mostSteps * (1.0 - 1e-9);
    std::vector<std::string> series;
    for (double decade = std::pow(10.0, std::floor(std::log10(least))); decade < duration; decade *= 10.0)
        for (const double mantissa : {1.0, 2.0, 5.0})
            if (const double step = roundedTo(mantissa * decade, 1);
                step >= least && step < duration && series.size() < mostOfSeries)
                series.push_back(fewDigits(step, step < 0.999e-6 ? "ns" : "us", 1));
    std::ranges::reverse(series);
    return series;
}

std::vector<MethodSpec> springMethods(const Case& c)
{
    const std::vector<std::string> steps = stepSeries(c.run.duration);
    const std::vector<std::string> tolerances{"1e-4", "1e-5",  "1e-6",  "1e-7", "1e-8",
                                              "1e-9", "1e-10", "1e-11", "1e-12"};
    std::vector<MethodSpec> methods;
    for (const std::string integrator : {"rk4", "rk4-events", "newmark"}) {
        methods.push_back({integrator, {{"run.integrator", integrator}}, "run.step", steps, {"10 ns"}});
        if (integrator == "rk4") methods.back().ensemble.push_back("5 ns");
    }
    for (const std::string integrator : {"dopri5", "cvode"})
        if (integrator != "cvode" || haveCvode)
            methods.push_back({integrator, {{"run.integrator", integrator}}, "run.tolerance", tolerances, {"1e-8"}});
    return methods;
}

std::vector<MethodSpec> filmMethods(const Case& c, bool inTime)
{
    const std::vector<std::string> nodes = inTime
                                               ? std::vector<std::string>{"49", "97", "145", "193"}
                                               : std::vector<std::string>{"33", "49", "65", "97", "145", "193", "289"};
    const std::string ownScheme = toText(c, *findField("film.scheme")), ownGrid = toText(c, *findField("film.grid"));
    std::vector<MethodSpec> methods;
    const auto add = [&](const std::string& scheme, const std::string& grid) {
        methods.push_back(
            {scheme + ", " + grid, {{"film.scheme", scheme}, {"film.grid", grid}}, "film.nodes", nodes, {"97"}});
    };
    for (const std::string grid : {"adapted", "graded", "uniform"}) add(ownScheme, grid);
    for (const std::string scheme : {"upwind", "power-law", "exponential", "complete-flux"})
        if (scheme != ownScheme) add(scheme, ownGrid);
    if (!inTime) {
        methods.push_back({"line-multigrid", {{"film.solver", "line-multigrid"}}, "film.nodes", nodes, {}});
        return methods;
    }
    const std::vector<std::string> errors{"0.5 nm", "0.05 nm", "0.005 nm", "0.0005 nm"};
    for (const std::string coupling : {"monolithic", "staggered"})
        methods.push_back({coupling, {{"film.coupling", coupling}}, "run.step_error", errors, {"0.005 nm"}});
    return methods;
}

int nodesOfFinest(const std::vector<SweptMethod>& methods)
{
    int most = 17;
    for (const SweptMethod& method : methods)
        for (const MethodSetting& setting : method.settings)
            most = std::max({most, setting.c.film.nodes[0], setting.c.film.nodes[1]});
    return most;
}

template <class Get>
double leastOf(const std::vector<SweptMethod>& methods, double least, Get get)
{
    for (const SweptMethod& method : methods)
        for (const MethodSetting& setting : method.settings) least = std::min(least, get(setting.c));
    return least;
}

/// Finer than any fixed step of the methods, within some bounds.
double referenceStep(const Case& c, const std::vector<SweptMethod>& methods)
{
    const double finest = leastOf(methods, 2.0 * c.run.duration / fewestReferenceSteps, [](const Case& each) {
        const IntegratorKind kind = each.run.integrator;
        return hasFixedStep(kind) ? each.run.step : each.run.duration;
    });
    return std::max(0.5 * finest, c.run.duration / mostReferenceSteps);
}

} // namespace

std::vector<MethodSpec> defaultMethods(const Case& c, bool inTime)
{
    if (c.model == ModelKind::Springs) return springMethods(c);
    return c.model == ModelKind::Film ? filmMethods(c, inTime) : std::vector<MethodSpec>{};
}

std::vector<ReferenceCase> defaultReferences(const Case& c, bool inTime, const std::vector<SweptMethod>& methods)
{
    if (c.model == ModelKind::Springs) return springReferences(c, referenceStep(c, methods));
    if (c.model != ModelKind::Film) return {};
    const int cells = nodesOfFinest(methods) - 1;
    const int nodes = std::min(2049, std::max(cells / 16 + 1, cells * 3 / 2 / 16) * 16 + 1);
    if (!inTime) return gridReferences(c, nodes, {});
    return gridReferences(
        c, nodes, 0.25 * leastOf(methods, c.run.stepError, [](const Case& each) { return each.run.stepError; }));
}

} // namespace touchdown
