// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/run_class.h"

#include <algorithm>
#include <cmath>

#include "core/studies/runs/trajectory_error.h"
#include "core/studies/study/few_digits.h"

namespace touchdown {

namespace {

constexpr double gridsEnergy = 1.5; // of the reference's imbalance, which is the grid's and not the steps'

double figure(const Summary& summary, std::string_view wanted)
{
    for (const RunFigure& each : summary.figures)
        if (each.quantity.name == wanted) return each.value;
    return 0.0;
}

} // namespace

std::string_view name(RunClass kind)
{
    switch (kind) {
    case RunClass::Agrees: return "agrees with the reference";
    case RunClass::OtherWay: return "right end by another way";
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

RunVerdict classify(const Case& c, const MeasuredRun& run, const ProvenReference& reference, const ClassRule& rule)
{
    RunVerdict verdict;
    const bool hasReference = reference.problem.empty();
    const std::string truth =
        hasReference ? "; the reference " + outcomeText(reference.run) : "; " + knowledgeOf(reference);
    if (hasReference) verdict.apart = trajectoryError(run, reference.run, 0).at(ErrorMeasure::Worst).value_or(0.0);
    verdict.imbalance = figure(run.summary, "energy_balance");
    if (!run.valid()) {
        const bool alike = hasReference && reference.endKnown && sameOutcome(run, reference.run);
        switch (run.summary.failure) {
        case RunFailure::Chattering: verdict.kind = RunClass::Chatter; break;
        case RunFailure::FrontSpringLost:
        case RunFailure::RearSpringLost: verdict.kind = RunClass::LostSpring; break;
        case RunFailure::Diverged: verdict.kind = RunClass::Diverged; break;
        default: verdict.kind = RunClass::Stopped;
        }
        if (alike) verdict.kind = RunClass::AsReference;
        verdict.sentence = outcomeText(run) + (alike ? "; so does the reference" : truth);
        return verdict;
    }
    if (!hasReference || !reference.endKnown) {
        verdict.kind = RunClass::NotDetermined;
        verdict.sentence = outcomeText(run) + "; " + knowledgeOf(reference);
        return verdict;
    }
    const bool fixedFilm = c.model == ModelKind::Film && c.run.steps == StepControl::Fixed;
    if (!sameOutcome(run, reference.run)) {
        verdict.kind = RunClass::WrongEnd;
        verdict.sentence = outcomeText(run) + truth;
    } else if (verdict.imbalance >
               std::max(rule.energyDrift, gridsEnergy * figure(reference.run.summary, "energy_balance"))) {
        verdict.kind = RunClass::DriftingEnergy;
        verdict.sentence = "the energy imbalance is " + fewDigits(100.0 * verdict.imbalance, "") +
                           " % of the largest change of the energy; it " + outcomeText(run);
    } else if (fixedFilm && run.summary.rejectedSteps > 0) {
        verdict.kind = RunClass::CutSteps;
        verdict.sentence =
            std::to_string(run.summary.rejectedSteps) + " steps found no solution and were cut; it " + outcomeText(run);
    } else if (!reference.horizon && verdict.apart > rule.agreement) {
        verdict.kind = RunClass::OtherWay;
        verdict.sentence = outcomeText(run) + " as the reference does, but is up to " + fewDigits(verdict.apart, "nm") +
                           " away from it in between";
    } else {
        verdict.kind = RunClass::Agrees;
        verdict.sentence = outcomeText(run) + " as the reference does" +
                           (reference.horizon ? ", whose end alone is determined"
                                              : ", within " + fewDigits(verdict.apart, "nm") + " all the way");
    }
    return verdict;
}

} // namespace touchdown
