// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis/held_steps.h"

#include <algorithm>
#include <cmath>

#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/physics/contact/ono_yamane.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

namespace {

constexpr double fewestSamples = 1000.0; // of a hold, so that its last tenth has statistics

/// Mean of a column between two times; 0 where there is no sample.
double meanBetween(const std::vector<double>& time, const std::vector<double>& column, double begin, double end)
{
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < std::min(time.size(), column.size()); ++i) {
        if (time[i] < begin || time[i] > end) continue;
        sum += column[i];
        count += 1.0;
    }
    return count > 0.0 ? sum / count : 0.0;
}

/// The branch on which the pad ends: forces tell it, but for asperities that have let go and menisci that pull nothing;
/// there the last switch of the law tells it, or the start.
ContactBranch branchAfter(const HeldEnd& before)
{
    const Summary& end = before.summary;
    if (valueOr(end.final, "contact_force", 0.0) != 0.0 || valueOr(end.final, "adhesion_force", 0.0) != 0.0)
        return ContactBranch::TakeOff;
    for (auto event = end.events.rbegin(); event != end.events.rend(); ++event)
        if (const auto branch = branchAfterSwitch(event->name)) return *branch;
    const auto law = characteristic(before.run); // other laws have no branches
    if (law && before.startSpacing >= law->takeOff) return ContactBranch::TouchDown;
    if (law && before.startSpacing <= law->touchDown) return ContactBranch::TakeOff;
    return before.run.initial.branch;
}

} // namespace

bool belongsToStart(const std::string& key) { return key.starts_with("initial."); }

std::string setParameter(Case& c, const Parameter& parameter, double value)
{
    Case changed = c;
    if (const auto problem = setFromNumber(changed, parameter, value)) return parameter.key + ": " + *problem;
    for (const CaseProblem& problem : checkCombinations(changed)) return problem.key + ": " + problem.message;
    c = std::move(changed);
    return {};
}

std::optional<Case> caseWith(Case c, const Parameter& parameter, double value)
{
    return setParameter(c, parameter, value).empty() ? std::optional(std::move(c)) : std::nullopt;
}

std::optional<double> readEnd(StudyReader& reader, const char* key, const Parameter& parameter,
                              std::optional<double> standard)
{
    const bool given = reader.has(key);
    if (!given && !standard) reader.add(key, "is missing: the parameter has no range of its own");
    const std::optional<double> value =
        given ? reader.number(key, parameter.unit, parameter.displayUnit, parameter.minimum, parameter.maximum)
              : standard;
    if (!value) return {};
    Case at = reader.start();
    const std::string problem = setParameter(at, parameter, *value);
    if (problem.empty()) return value;
    reader.add(key, problem);
    return {};
}

void carryOver(Case& next, const HeldEnd& before)
{
    const auto last = [&](std::string_view name) { return valueOr(before.summary.final, name, 0.0); };
    InitialCase& initial = next.initial;
    const double height = last("height");
    initial.pitch = last("pitch");
    initial.verticalVelocity = last("vertical_velocity");
    initial.pitchVelocity = last("pitch_velocity");
    initial.branch = branchAfter(before);
    if (next.model == ModelKind::Springs) {
        initial.flyingHeight = height - next.springs.padDistance * initial.pitch;
        return;
    }
    initial.state = InitialState::Given;
    initial.nominalTrailingEdgeHeight = height - 0.5 * next.slider.length * initial.pitch;
    initial.roll = last("roll");
    initial.rollVelocity = last("roll_velocity");
}

HeldStep holdValue(const HeldSteps& steps, double value, HeldEnd& last, std::vector<std::string>& warnings,
                   const GoOn& goOn, const ShareTeller& tell)
{
    HeldStep step;
    step.value = value;
    Case c = steps.start;
    c.run.duration = steps.hold;
    c.run.sampleInterval = std::min(c.run.sampleInterval, steps.hold / fewestSamples);
    c.run.step = std::min(c.run.step, steps.hold);
    c.spectrum.start = 0.0;
    step.problem = setParameter(c, steps.parameter, value);
    if (!step.problem.empty()) {
        last.valid = false;
        return step;
    }
    step.anew = !last.valid;
    if (last.valid) carryOver(c, last);
    const std::string spacing(spacingOf(c));
    MeasuredRun run = measureRun(c, {spacing}, goOn, {}, tell);
    step.done = run.summary.status != RunStatus::Cancelled;
    if (!step.done) return step;
    step.problem = run.summary.message;
    step.end = run.end;
    step.spacing = valueOr(run.summary.tail, spacing, step.spacing);
    if (const Statistics* pitch = valueIn(run.summary.tail, "pitch")) step.pitch = pitch->mean;
    for (const std::string& warning : run.summary.warnings)
        if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(warning);
    step.drift =
        std::abs(step.end.spacing - meanBetween(run.time, run.columns[0], 0.45 * steps.hold, 0.55 * steps.hold));
    const double begin = run.columns[0].empty() ? 0.0 : run.columns[0].front();
    last = {std::move(c), std::move(run.summary), begin, run.end.kind != EndKind::Failed};
    return step;
}

bool holdAll(const HeldSteps& steps, const GoOn& goOn, const std::function<void(std::size_t, HeldStep&&)>& done,
             std::vector<std::string>& warnings, const std::function<ShareTeller(std::size_t)>& tellerOf)
{
    HeldEnd last;
    const std::size_t count = steps.values.size();
    for (std::size_t i = 0; i < 2 * count; ++i) {
        const bool back = i >= count;
        HeldStep step = holdValue(steps, steps.values[back ? 2 * count - 1 - i : i], last, warnings, goOn,
                                  tellerOf ? tellerOf(i) : ShareTeller());
        if (goOn && !goOn()) return false;
        step.back = back;
        step.done = true;
        done(i, std::move(step));
    }
    return true;
}

} // namespace touchdown
