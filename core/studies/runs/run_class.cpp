// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/run_class.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/formats/units.h"
#include "core/studies/runs/proven_reference.h"
#include "core/studies/runs/trajectory_error.h"

namespace touchdown {

namespace {

constexpr double gridsEnergy = 1.5; // of the reference's imbalance, which is the grid's and not the steps'

double figure(const Summary& summary, std::string_view wanted)
{
    for (const RunFigure& each : summary.figures)
        if (each.quantity.name == wanted) return each.value;
    return 0.0;
}

struct ClassText {
    std::string_view name;
    int severity;
};
constexpr std::array<ClassText, runClasses> classes{{
    {"agrees with the reference", 0},
    {"right end by another way", 1},
    {"steps were cut", 1},
    {"not determined", 1},
    {"fails as the reference", 1},
    {"drifting energy", 2},
    {"wrong end state", 2},
    {"chatter", 3},
    {"lost spring", 3},
    {"diverged", 3},
    {"stopped", 3},
}};

} // namespace

std::string_view name(RunClass kind) { return classes[static_cast<std::size_t>(kind)].name; }
int severity(RunClass kind) { return classes[static_cast<std::size_t>(kind)].severity; }

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
        verdict.sentence = "the energy imbalance is " + percent(verdict.imbalance) +
                           " of the largest change of the energy; it " + outcomeText(run);
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
