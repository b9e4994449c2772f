// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/springs/spring_run.h"

#include <cmath>

#include "core/formats/units.h"
#include "core/numerics/adaptive.h"
#include "core/numerics/cvode.h"
#include "core/numerics/fixed_step.h"
#include "core/numerics/newmark.h"
#include "core/simulation/springs/spring_recorder.h"

namespace touchdown {

namespace {

/// Runs the integrator of the case from the model's initial state; `step` [s] is for fixed-step ones.
IntegrationResult integrateSprings(const SpringModel& model, const Case& c, double step, SpringRecorder& recorder)
{
    const Start<SpringModel> start{model.initialState(), model.initialMode()};
    const double until = c.run.duration;
    const FixedStepOptions fixed{.step = step};
    const AdaptiveOptions adaptive{.tolerance = c.run.tolerance, .firstStep = 1e-3 * model.shortestPeriod()};
    recorder.begin(start.y, start.mode);
    switch (c.run.integrator) {
    case IntegratorKind::Rk4: return integrateNaively(model, start, until, fixed, recorder);
    case IntegratorKind::Rk4Events:
        return integrateFixed(model, Rk4Stepper<SpringModel>(model), start, until, fixed, recorder);
    case IntegratorKind::Newmark: {
        const NewmarkOptions options{.beta = c.run.newmarkBeta, .gamma = c.run.newmarkGamma};
        return integrateFixed(model, NewmarkStepper<SpringModel>(model, options), start, until, fixed, recorder);
    }
    case IntegratorKind::Dopri5: break;
    case IntegratorKind::Cvode:
        if constexpr (haveCvode) return integrateCvode(model, start, until, adaptive, recorder);
        break;
    }
    return integrateAdaptive(model, start, until, adaptive, recorder);
}

constexpr double sameFlyingHeight = 0.1e-9; // [m], between end states that count as the same
constexpr double looseTolerance = 1e-4;     // from which on the energy of an adaptive run is looked at [-]
constexpr double mostImbalance = 0.01;      // of the energy, of the largest change of a part [-]

std::string time(double t) { return fewDigitsOfTime(t, 4); }
std::string spacing(double h) { return formatQuantity(std::round(h * 1e13) / 1e13, "nm"); }
std::string angle(double a) { return formatQuantity(std::round(a * 1e10) / 1e10, "urad"); }

/// Why the integrator ended, for a person.
RunEnd explain(const IntegrationResult& result)
{
    const std::string at = " at " + time(result.time);
    switch (result.end) {
    case IntegrationEnd::Reached:
    case IntegrationEnd::Stopped: return {};
    case IntegrationEnd::Diverged:
        return {RunStatus::Diverged, RunFailure::Diverged,
                "the motion diverged" + at + ": the state outgrew all bounds; use a smaller step or tolerance"};
    case IntegrationEnd::StepUnderflow:
        return {RunStatus::Failed, RunFailure::NoStep,
                "the step size fell below round-off" + at + ": the tolerance cannot be met; use a larger tolerance"};
    case IntegrationEnd::NewtonFailed:
        return {RunStatus::Failed, RunFailure::NotConverged,
                "Newton's iteration of an implicit step did not converge" + at + "; use a smaller step"};
    case IntegrationEnd::Chattering:
        return {RunStatus::Failed, RunFailure::Chattering,
                "chattering" + at +
                    ": more than 64 switches within one period of the fastest motion; the contact law holds the pad "
                    "between two laws (d_e close to d_s)"};
    case IntegrationEnd::Tunnelled:
        return {
            RunStatus::Failed, RunFailure::Tunnelled,
            "a step tunnelled through the wall of an air spring" + at +
                ": it crossed the cutoff d_1 with energy that the step itself made; use a smaller step or tolerance"};
    }
    return {};
}

/// A spring that does not carry at the end, and has not for the last tenth of the run, is lost for good.
RunEnd lostSpring(const SpringRecorder& recorder, const SpringModel& model, double duration)
{
    for (const int guard : {SpringModel::Rear, SpringModel::Front}) {
        const double since = recorder.lostSince(guard);
        if (since < 0.0 || since > 0.9 * duration) continue;
        const SpringRecorder::Point& last = recorder.last();
        const bool pressed = last.mode.contact == ContactRegion::Pressed || last.mode.contact == ContactRegion::Lifting;
        const RunFailure failure =
            guard == SpringModel::Rear ? RunFailure::RearSpringLost : RunFailure::FrontSpringLost;
        return {RunStatus::Failed, failure,
                std::string(name(failure)) + " since " + time(since) +
                    (pressed ? "; the pad hangs on the contact stiffness at " : "; the slider ends at ") +
                    spacing(model.guards(last.y.head<2>())[SpringModel::Pad]) + ", " + angle(last.y[1]) +
                    ": outside the model"};
    }
    return {};
}

Summary runOnce(const Case& c, double step, const RunCallback& callback, const RunOptions& options = {})
{
    const SpringModel model(c);
    SpringRecorder recorder(model, c, callback);
    SpringEnergyBalance balance(model, c);
    const bool loose = !hasFixedStep(c.run.integrator) && c.run.tolerance >= looseTolerance;
    if (options.energyBalance || loose) recorder.balance = &balance;

    const double solverBegin = wallClock();
    const IntegrationResult result = integrateSprings(model, c, step, recorder);
    const double solverSeconds = wallClock() - solverBegin - recorder.run().secondsOutside();
    recorder.flush();

    RunEnd end = recorder.end();
    double endTime = recorder.endTime();
    if (end.completed()) {
        end = explain(result);
        if (!end.completed()) endTime = result.time;
    }
    if (end.completed()) end = lostSpring(recorder, model, c.run.duration);
    std::vector<double> values(recorder.run().quantities().size());
    model.observe(recorder.last().y, recorder.last().mode, values.data());
    Summary summary = recorder.run().summary(end, endTime, values);
    summary.steps = result.steps;
    summary.rejectedSteps = result.rejectedSteps;
    summary.evaluations = result.evaluations;
    if (loose && balance.imbalance() > mostImbalance)
        summary.warnings.push_back("the energy imbalance is " +
                                   formatNumber(std::round(1e3 * balance.imbalance()) / 10.0) +
                                   " % of the energy's largest change: run.tolerance is too loose for a valid run");
    if (options.energyBalance)
        summary.figures.push_back(
            {{"energy_balance", "1", "1", "Energy imbalance, against the largest change of a part"},
             balance.imbalance(),
             false,
             true});
    recorder.run().setTimes(summary);
    summary.solverSeconds = solverSeconds;
    return summary;
}

double finalValue(const Summary& summary, std::string_view name)
{
    for (const auto& [quantity, value] : summary.final)
        if (quantity == name) return value;
    return NAN;
}

Statistics tailOf(const Summary& summary, std::string_view name)
{
    for (const auto& [quantity, statistics] : summary.tail)
        if (quantity == name) return statistics;
    return {NAN, NAN, NAN, NAN};
}

/// Runs again with half the step and compares where the slider ends.
StepCheck checkStep(const Case& c, const Summary& full, const RunCallback& callback)
{
    SampleBatch none;
    none.columns.resize(SpringModel::quantities(c).size());
    const RunCallback stopOnly = [&](const RunUpdate& update) {
        return !callback || callback({c.run.duration, update.duration, none, {}, {}});
    };
    StepCheck check;
    check.step = 0.5 * c.run.step;
    const Summary half = runOnce(c, check.step, stopOnly);
    check.flyingHeight = finalValue(half, "flying_height");
    check.pitch = finalValue(half, "pitch");
    const auto [before, spreadBefore, least, most] = tailOf(full, "flying_height");
    const auto [after, spreadAfter, leastAfter, mostAfter] = tailOf(half, "flying_height");
    const bool sameMean = std::abs(before - after) <= sameFlyingHeight;
    check.sameEndState =
        half.status == full.status && sameMean && std::abs(spreadBefore - spreadAfter) <= sameFlyingHeight;
    const std::string halved = "halving the step to " + formatQuantity(check.step, "ns");
    if (half.status == RunStatus::Cancelled) {
        check.message = halved + " was stopped before it ended";
    } else if (half.status != full.status) {
        check.message = halved + " changes how the run ends: " + (half.message.empty() ? "it completes" : half.message);
    } else if (check.sameEndState) {
        check.message = halved + " leads to the same end state (mean flying height " + spacing(after) + ")";
    } else if (sameMean) {
        check.message =
            halved + " changes the end state: the spread of the flying height in the last tenth goes from " +
            spacing(spreadBefore) + " to " + spacing(spreadAfter) + ", so this run has not converged in time";
    } else {
        check.message = halved + " changes the end state: the mean flying height of the last tenth goes from " +
                        spacing(before) + " to " + spacing(after) + ", so this run has not converged in time";
    }
    return check;
}

} // namespace

Summary runSprings(const Case& c, const RunCallback& callback, const RunOptions& options)
{
    Summary summary = runOnce(c, c.run.step, callback, options);
    if (c.run.stepCheck && hasFixedStep(c.run.integrator) && summary.status != RunStatus::Cancelled &&
        !summary.tail.empty()) {
        summary.stepCheck = checkStep(c, summary, callback);
        if (!summary.stepCheck->sameEndState) summary.warnings.push_back(summary.stepCheck->message);
    }
    return summary;
}

} // namespace touchdown
