// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/proven_reference.h"

#include <algorithm>
#include <cmath>

#include "core/case/integrator_kind.h"
#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "core/numerics/cvode.h"
#include "core/studies/runs/swept_method.h"
#include "core/studies/runs/trajectory_error.h"

namespace touchdown {

namespace {

constexpr double leastStepError = 1e-18; // [m]
constexpr double nudge = 1e-13;          // of a start [m]

ReferenceCase springReference(Case c, IntegratorKind integrator, double tolerance, double step,
                              const std::string& setting)
{
    c.run.integrator = integrator;
    c.run.tolerance = tolerance;
    c.run.step = step;
    return {nameOf(toText(c, *findParameter("run.integrator")), setting), c};
}

ReferenceCase filmReference(Case c, const std::string& label, std::optional<double> stepError)
{
    if (!stepError) return {label, c};
    c.run.steps = StepControl::Adaptive;
    c.run.stepError = std::max(leastStepError, *stepError);
    return {nameOf(label, "step error " + fewDigits(c.run.stepError, "nm")), c};
}

double distanceOf(const MeasuredRun& a, const MeasuredRun& b)
{
    return trajectoryError(a, b, 0).at(ErrorMeasure::Worst).value_or(INFINITY);
}

struct Pair {
    std::size_t first = 0, second = 0;
};
/// The two of the highest score above `least`.
template <class Score>
std::optional<Pair> bestPair(const std::vector<MeasuredRun>& runs, double least, Score score)
{
    std::optional<Pair> best;
    for (std::size_t i = 0; i < runs.size(); ++i)
        for (std::size_t k = i + 1; k < runs.size(); ++k) {
            if (runs[i].summary.status == RunStatus::Cancelled || runs[k].summary.status == RunStatus::Cancelled)
                continue;
            const double its = score(runs[i], runs[k]);
            if (!(its > least)) continue;
            best = Pair{i, k};
            least = its;
        }
    return best;
}

} // namespace

std::vector<ReferenceCase> springReferences(const Case& c, double step)
{
    const double rounded = roundedTo(step, 3);
    std::vector<ReferenceCase> families{
        springReference(c, IntegratorKind::Dopri5, 1e-14, c.run.step, "1e-14"),
        springReference(c, IntegratorKind::Rk4Events, c.run.tolerance, rounded, fewDigitsOfTime(rounded, 3))};
    if (haveCvode) families.push_back(springReference(c, IntegratorKind::Cvode, 1e-13, c.run.step, "1e-13"));
    return families;
}

std::vector<ReferenceCase> gridReferences(const Case& given, int nodes, std::optional<double> stepError)
{
    Case c = given;
    c.film.nodes = {nodes, nodes};
    c.film.scheme = ConvectionScheme::CompleteFlux;
    c.film.solver = FilmSolver::Newton;
    c.film.coupling = FilmCoupling::Monolithic;
    std::vector<ReferenceCase> families;
    for (const GridKind grid : {GridKind::Adapted, GridKind::Graded}) {
        c.film.grid = grid;
        families.push_back(filmReference(c,
                                         (grid == GridKind::Adapted ? "an " : "a ") +
                                             toText(c, *findParameter("film.grid")) + " grid of " +
                                             std::to_string(nodes) + " nodes",
                                         stepError));
    }
    return families;
}

std::vector<ReferenceCase> couplingReferences(const Case& given)
{
    constexpr double share = 0.01, shareInTurns = 0.001; // of the case's step error
    Case c = given;
    std::vector<ReferenceCase> families;
    for (const FilmCoupling coupling : {FilmCoupling::Monolithic, FilmCoupling::Staggered}) {
        c.film.coupling = coupling;
        const double stepError = given.run.stepError * (coupling == FilmCoupling::Monolithic ? share : shareInTurns);
        families.push_back(filmReference(c, toText(c, *findParameter("film.coupling")), stepError));
    }
    return families;
}

ReferenceCase ensembleReference(const Case& c)
{
    if (c.model == ModelKind::Springs) return springReference(c, IntegratorKind::Dopri5, 1e-12, c.run.step, "1e-12");
    return filmReference(c, "the case", 0.1 * c.run.stepError);
}

std::vector<Case> nudgedStarts(const Case& c)
{
    const bool springs = c.model == ModelKind::Springs;
    std::vector<Case> starts;
    for (const double times :
         springs ? std::vector<double>{-4.0, -3.0, -2.0, -1.0, 1.0, 2.0, 3.0, 4.0} : std::vector<double>{-1.0, 1.0}) {
        InitialCase& initial = starts.emplace_back(c).initial;
        (springs                                 ? initial.flyingHeight
         : initial.state == InitialState::Static ? initial.heightOffset
                                                 : initial.nominalTrailingEdgeHeight) += times * nudge;
    }
    return starts;
}

ProvenReference proveReference(const std::vector<ReferenceCase>& cases, std::vector<MeasuredRun> runs, double agreement,
                               double sameDistance)
{
    ProvenReference reference;
    std::optional<Pair> pair = bestPair(runs, -INFINITY, [&](const MeasuredRun& a, const MeasuredRun& b) {
        return sameOutcome(a, b, sameDistance) ? -distanceOf(a, b) : -INFINITY;
    });
    reference.endKnown = pair.has_value();
    const auto together = [&](const MeasuredRun& a, const MeasuredRun& b) {
        return firstApart(a, b, agreement).value_or(std::min(a.columns[0].size(), b.columns[0].size()));
    };
    // No two end alike: those that stay together for the longest time.
    if (!pair)
        pair = bestPair(
            runs, 0.0, [&](const MeasuredRun& a, const MeasuredRun& b) { return static_cast<double>(together(a, b)); });
    if (!pair) {
        reference.problem = "no two of the reference runs agree at all";
        for (std::size_t i = 0; i < runs.size(); ++i)
            if (!runs[i].valid()) reference.problem += "; " + cases[i].label + ": " + runs[i].summary.message;
        return reference;
    }
    reference.which = pair->first;
    reference.label = cases[pair->first].label;
    reference.other = cases[pair->second].label;
    reference.run = std::move(runs[pair->first]);
    reference.check = std::move(runs[pair->second]);
    reference.apart = distanceOf(reference.run, reference.check);
    const std::vector<double>& time = reference.run.time;
    const bool parts = !reference.endKnown || firstApart(reference.run, reference.check, agreement);
    reference.samples = parts ? together(reference.run, reference.check) : time.size();
    if (parts) reference.horizon = time[std::min(reference.samples, time.size() - 1)];
    return reference;
}

void proveEnd(ProvenReference& reference, const std::vector<MeasuredRun>& nudged, double sameDistance)
{
    if (!std::ranges::all_of(nudged,
                             [&](const MeasuredRun& each) { return sameOutcome(reference.run, each, sameDistance); }))
        reference.endKnown = false;
}

std::string knowledgeOf(const ProvenReference& reference)
{
    if (!reference.problem.empty()) return "not determined: " + reference.problem;
    const std::string apart = fewDigits(reference.apart, "nm"), end = outcomeText(reference.run);
    if (!reference.endKnown)
        return "not determined: it " + end +
               (sameOutcome(reference.run, reference.check)
                    ? ", and differently from a start that hardly differs"
                    : ", and by another method " + outcomeText(reference.check));
    if (reference.horizon)
        return "the end is determined, the trajectory only up to " + fewDigitsOfTime(*reference.horizon) +
               ": two methods differ by up to " + apart + "; it " + end;
    return "determined: two methods differ by " + apart + " at most; it " + end;
}

} // namespace touchdown
