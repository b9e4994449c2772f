// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/run_class.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/units.h"
#include "core/studies/few_digits.h"
#include "core/studies/run_failure.h"

namespace touchdown {

namespace {

constexpr double referenceTolerance = 1e-12;
constexpr double checkStep = 1e-9;       // of rk4-events [s]
constexpr double mostCheckSteps = 4e6;
constexpr double nudge = 1e-13;          // of the start [m], a ten-thousandth of a nanometre, and up to four times that
constexpr double filmShare = 0.01, filmCheckShare = 0.001; // of the case's step error; in turns the slider goes by a rule of lower order
constexpr double gridsEnergy = 1.5;      // of the reference's imbalance, which is the grid's and not the steps'

double figure(const Summary& summary, std::string_view wanted)
{
    for (const RunFigure& each : summary.figures)
        if (each.quantity.name == wanted) return each.value;
    return 0.0;
}

ReferenceCases springReference(Case c)
{
    ReferenceCases cases;
    c.run.integrator = IntegratorKind::Dopri5;
    c.run.tolerance = referenceTolerance;
    cases.label = "dopri5, " + formatNumber(referenceTolerance);
    cases.reference = c;
    for (const double times : {-4.0, -3.0, -2.0, -1.0, 1.0, 2.0, 3.0, 4.0}) {
        Case& nudged = cases.nudged.emplace_back(c);
        nudged.initial.flyingHeight += times * nudge;
    }
    c.run.integrator = IntegratorKind::Rk4Events;
    c.run.step = std::max(checkStep, c.run.duration / mostCheckSteps);
    cases.checkLabel = "rk4-events, " + fewDigitsOfTime(c.run.step);
    cases.check = c;
    return cases;
}

ReferenceCases filmReference(Case c)
{
    ReferenceCases cases;
    c.run.steps = StepControl::Adaptive;
    const double stepError = c.run.stepError;
    c.run.stepError = std::max(1e-18, filmShare * stepError);
    c.film.coupling = FilmCoupling::Monolithic;
    cases.label = "monolithic, step error " + fewDigits(c.run.stepError, "nm");
    cases.reference = c;
    for (const double times : {-1.0, 1.0}) {
        Case& nudged = cases.nudged.emplace_back(c);
        (c.initial.state == InitialState::Static ? nudged.initial.heightOffset : nudged.initial.nominalTrailingEdgeHeight) += times * nudge;
    }
    c.film.coupling = FilmCoupling::Staggered;
    c.run.stepError = std::max(1e-18, filmCheckShare * stepError);
    cases.checkLabel = "staggered, step error " + fewDigits(c.run.stepError, "nm");
    cases.check = c;
    return cases;
}

} // namespace

std::string_view name(RunClass kind)
{
    switch (kind) {
    case RunClass::Agrees: return "agrees with the reference";
    case RunClass::OtherWay: return "right end, another way";
    case RunClass::CutSteps: return "steps were cut";
    case RunClass::NotDetermined: return "not determined";
    case RunClass::AsReference: return "fails as the reference";
    case RunClass::DriftingEnergy: return "drifting energy";
    case RunClass::WrongEnd: return "wrong end state";
    case RunClass::Chatter: return "chatter";
    case RunClass::LostSpring: return "lost spring";
    case RunClass::Diverged: return "diverged";
    case RunClass::Stopped: return "stopped";
    }
    return {};
}

int severity(RunClass kind)
{
    switch (kind) {
    case RunClass::Agrees: return 0;
    case RunClass::OtherWay:
    case RunClass::CutSteps:
    case RunClass::NotDetermined:
    case RunClass::AsReference: return 1;
    case RunClass::DriftingEnergy:
    case RunClass::WrongEnd: return 2;
    case RunClass::Chatter:
    case RunClass::LostSpring:
    case RunClass::Diverged:
    case RunClass::Stopped: return 3;
    }
    return 3;
}

ReferenceCases referenceCases(const Case& c) { return c.model == ModelKind::Springs ? springReference(c) : filmReference(c); }

bool sameOutcome(const MeasuredRun& a, const MeasuredRun& b)
{
    if (a.valid() != b.valid()) return false;
    return a.valid() ? sameEnd(a.end, b.end) : failureOf(a.summary) == failureOf(b.summary);
}

std::string outcomeText(const MeasuredRun& run)
{
    if (!run.valid()) return "fails: " + run.summary.message;
    const std::string at = fewDigits(run.end.spacing, "nm", 3);
    switch (run.end.kind) {
    case EndKind::Flying: return "flies at " + at;
    case EndKind::Contact: return "ends in contact at " + at;
    case EndKind::Intermittent: return "goes in and out of contact about " + at;
    case EndKind::Failed: break;
    }
    return "has no end";
}

double largestDistance(const MeasuredRun& a, const MeasuredRun& b)
{
    double largest = 0.0;
    const std::vector<double>&x = a.columns.front(), &y = b.columns.front();
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) largest = std::max(largest, std::abs(x[i] - y[i]));
    return largest;
}

void judgeReference(ReferenceRun& r, const ClassRule& rule)
{
    r.apart = largestDistance(r.run, r.check);
    r.horizon.reset();
    const std::size_t both = std::min(r.run.time.size(), r.check.time.size());
    for (std::size_t i = 0; i < both && !r.horizon; ++i)
        if (std::abs(r.run.columns[0][i] - r.check.columns[0][i]) > rule.agreement) r.horizon = r.run.time[i];
    r.endKnown = sameOutcome(r.run, r.check) && std::ranges::all_of(r.nudged, [&](const MeasuredRun& each) { return sameOutcome(r.run, each); });
    const std::string apart = fewDigits(r.apart, "nm");
    if (!r.horizon && r.endKnown) {
        r.sentence = "determined: two methods differ by " + apart + " at most; it " + outcomeText(r.run);
    } else if (r.endKnown) {
        r.sentence = "the end is determined, the trajectory to " + fewDigitsOfTime(*r.horizon) + " only: two methods part by " + apart + "; it " + outcomeText(r.run);
    } else {
        r.sentence = "not determined: it " + outcomeText(r.run);
        const auto other = std::ranges::find_if(r.nudged, [&](const MeasuredRun& each) { return !sameOutcome(r.run, each); });
        if (!sameOutcome(r.run, r.check)) r.sentence += ", and by another method " + outcomeText(r.check);
        else if (other != r.nudged.end()) r.sentence += ", and from a start that hardly differs " + outcomeText(*other);
    }
}

RunVerdict classify(const Case& c, const MeasuredRun& run, const ReferenceRun& reference, const ClassRule& rule)
{
    RunVerdict verdict;
    verdict.apart = largestDistance(run, reference.run);
    verdict.imbalance = figure(run.summary, "energy_balance");
    const std::string truth = "; the reference " + outcomeText(reference.run);
    if (!run.valid()) {
        const bool alike = reference.endKnown && sameOutcome(run, reference.run);
        switch (run.summary.failure) {
        case RunFailure::Chattering: verdict.kind = RunClass::Chatter; break;
        case RunFailure::SpringLost: verdict.kind = RunClass::LostSpring; break;
        case RunFailure::Diverged: verdict.kind = RunClass::Diverged; break;
        default: verdict.kind = RunClass::Stopped;
        }
        if (alike) verdict.kind = RunClass::AsReference;
        verdict.sentence = outcomeText(run) + (alike ? "; so does the reference" : truth);
        return verdict;
    }
    if (!reference.endKnown) {
        verdict.kind = RunClass::NotDetermined;
        verdict.sentence = outcomeText(run) + "; " + reference.sentence;
        return verdict;
    }
    const bool fixedFilm = c.model == ModelKind::Film && c.run.steps == StepControl::Fixed;
    if (!sameOutcome(run, reference.run)) {
        verdict.kind = RunClass::WrongEnd;
        verdict.sentence = outcomeText(run) + truth;
    } else if (verdict.imbalance > std::max(rule.energyDrift, gridsEnergy * figure(reference.run.summary, "energy_balance"))) {
        verdict.kind = RunClass::DriftingEnergy;
        verdict.sentence = "the books of the energy miss " + fewDigits(100.0 * verdict.imbalance, "") + " % of its largest change; it " + outcomeText(run);
    } else if (fixedFilm && run.summary.rejectedSteps > 0) {
        verdict.kind = RunClass::CutSteps;
        verdict.sentence = std::to_string(run.summary.rejectedSteps) + " steps found no solution and were cut; it " + outcomeText(run);
    } else if (!reference.horizon && verdict.apart > rule.agreement) {
        verdict.kind = RunClass::OtherWay;
        verdict.sentence = outcomeText(run) + " as the reference does, from which it is up to " + fewDigits(verdict.apart, "nm") + " away on the way";
    } else {
        verdict.kind = RunClass::Agrees;
        verdict.sentence = outcomeText(run) + " as the reference does" +
                           (reference.horizon ? ", whose end alone is determined" : ", within " + fewDigits(verdict.apart, "nm") + " all the way");
    }
    return verdict;
}

} // namespace touchdown
