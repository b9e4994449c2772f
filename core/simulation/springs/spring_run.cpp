// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/springs/spring_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/case/contact_law.h"
#include "core/case/integrator_kind.h"
#include "core/formats/units.h"
#include "core/simulation/springs/spring_integration.h"
#include "core/simulation/springs/spring_recorder.h"
#include "core/simulation/springs/springs_over_disk.h"

namespace touchdown {

namespace {

constexpr double sameFlyingHeight = 0.1e-9; // [m], between end states that count as the same
constexpr double looseTolerance = 1e-4;     // from which on the energy of an adaptive run is looked at [-]
constexpr double mostImbalance = 0.01;      // of the energy, of the largest change of a part [-]
constexpr double sameMotion = 1e-12;        // [m], between flying heights at the same time
constexpr double nearTouchDown = 1e-11;     // [m], above d_s
constexpr double finestTolerance = 1e-11;   // that is compared with a finer one [-]

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
RunEnd lostSpring(const SpringRecorder& recorder, double duration)
{
    const RunRecorder& run = recorder.run();
    const auto separation = static_cast<std::size_t>(findQuantity(run.quantities(), "flying_height"));
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
                    spacing(run.newest()[separation]) + ", " + angle(last.y[1]) + ": outside the model"};
    }
    return {};
}

/// `heights`: where its flying heights are kept at the multiples of the sample interval [m]; may be null.
Summary runOnce(const Case& c, const DiskUnderSprings& disk, double step, const RunCallback& callback,
                const RunOptions& options = {}, std::vector<double>* heights = nullptr)
{
    const SpringModel model(c, disk.moves() ? SpringModel::Guards::Zero() : disk.at(0.0).height);
    SpringRecorder recorder(model, disk, c, callback, options);
    if (heights) recorder.keepHeights();
    SpringEnergyBalance balance(model, disk);
    const bool loose = !hasFixedStep(c.run.integrator) && c.run.tolerance >= looseTolerance;
    if (options.energyBalance || loose) recorder.balance = &balance;

    const SpringModel::Mode mode = model.initialMode(disk.at(0.0).height);
    const double solverBegin = wallClock();
    recorder.begin(model.initialState(), mode);
    const IntegrationResult result = disk.moves() ? integrateOverDisk(model, disk, c, step, recorder)
                                                  : integrateSprings(model, c, step, model.shortestPeriod(), recorder);
    const double solverSeconds = wallClock() - solverBegin - recorder.run().secondsOutside();
    recorder.finish();

    RunEnd end = recorder.end();
    double endTime = recorder.endTime();
    if (end.completed()) {
        end = explain(result);
        if (!end.completed()) endTime = result.time;
    }
    if (end.completed()) end = lostSpring(recorder, c.run.duration);
    Summary summary = recorder.run().summary(end, endTime);
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
    summary.solverSeconds = recorder.run().solverSecondsBefore() + solverSeconds;
    if (heights) *heights = recorder.heights();
    return summary;
}

/// Of a run that is repeated for a check: nothing is reported, but the callback may stop it. Case and callback must
/// last.
RunCallback stopOnly(const Case& c, const RunCallback& callback)
{
    SampleBatch none;
    none.columns.resize(SpringModel::quantities(c).size());
    return [&c, &callback, none](const RunUpdate& update) {
        return !callback || callback({c.run.duration, update.duration, none, {}, {}});
    };
}

/// Runs again with half the step and compares where the slider ends.
StepCheck checkStep(const Case& c, const DiskUnderSprings& disk, const Summary& full, const RunCallback& callback)
{
    StepCheck check;
    check.step = 0.5 * c.run.step;
    const RunCallback silent = stopOnly(c, callback);
    const Summary half = runOnce(c, disk, check.step, silent);
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const Statistics none{unknown, unknown, unknown, unknown};
    check.flyingHeight = valueOr(half.final, "flying_height", unknown);
    check.pitch = valueOr(half.final, "pitch", unknown);
    const auto [before, spreadBefore, least, most] = valueOr(full.tail, "flying_height", none);
    const auto [after, spreadAfter, leastAfter, mostAfter] = valueOr(half.tail, "flying_height", none);
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

/// Whether the slider came so near to contact over a moving disk that a small error may have a large effect: where it
/// grazes, the effect grows with the square root of the error.
bool mayGraze(const Case& c, const Summary& summary)
{
    if (!summary.events.empty()) return true;
    const Extremes* height = valueIn(summary.extremes, "flying_height");
    return height && height->least < characteristic(c)->touchDown + nearTouchDown;
}

/// Runs again with another tolerance; a sentence where the motion is another then.
std::string otherMotion(const Case& c, const DiskUnderSprings& disk, const Summary& full,
                        const std::vector<double>& heights, const RunCallback& callback)
{
    Case other = c;
    other.run.tolerance *= c.run.tolerance > finestTolerance ? 0.01 : 10.0;
    const RunCallback silent = stopOnly(c, callback);
    std::vector<double> again;
    const Summary summary = runOnce(other, disk, other.run.step, silent, {}, &again);
    if (summary.status == RunStatus::Cancelled) return {};
    const std::size_t count = std::min(heights.size(), again.size());
    double most = 0.0;
    std::size_t first = count;
    for (std::size_t i = 0; i < count; ++i) {
        const double apart = std::abs(heights[i] - again[i]);
        if (apart > sameMotion) first = std::min(first, i);
        most = std::max(most, apart);
    }
    if (first == count && summary.status == full.status) return {};
    const bool another = most > sameFlyingHeight || summary.status != full.status;
    std::string text = another ? "run.tolerance does not determine the motion: with " : "with run.tolerance = ";
    text += formatNumber(roundedTo(other.run.tolerance, 6));
    if (first < count)
        text += " the flying height differs from " + time(double(first) * c.run.sampleInterval) + " on, by up to " +
                fewDigits(most, "nm", 2);
    if (summary.status != full.status)
        text += (first < count ? ", and" : "") + std::string(" the run ends otherwise: ") +
                (summary.message.empty() ? "it completes" : summary.message);
    else if (summary.verdict.motion != full.verdict.motion)
        text += ", and the motion is another: " + std::string(name(summary.verdict.motion));
    return text + "; a contact that the slider only grazes makes small errors large";
}

/// What only the surface itself shows: how long a step may be, and where the slider starts above it.
std::string reasonNotToStart(const Case& c, const DiskUnderSprings& disk)
{
    if (c.diskSurface.kind == DiskSurfaceKind::Flat) return {};
    if (hasFixedStep(c.run.integrator) && c.run.step > disk.longestStep())
        return "run.step must be at most " + fewDigits(disk.longestStep() / 1.005, "ns", 3) +
               ", in which half a cell of the measured surface passes under the slider";
    const SpringModel model(c);
    const SpringModel::Guards at = model.guards(model.initialState().head<2>(), disk.at(0.0).height);
    for (const int guard : {SpringModel::Front, SpringModel::Rear}) {
        const double stiffness = guard == SpringModel::Front ? c.springs.frontStiffness : c.springs.rearStiffness;
        if (stiffness > 0.0 && !(at[guard] > c.springs.cutoff))
            return std::string("initial.flying_height: the initial spacing at the ") +
                   (guard == SpringModel::Front ? "front" : "rear") +
                   " air bearing spring, above the disk under it, is " + spacing(at[guard]) +
                   ", which must be greater than springs.cutoff";
    }
    return {};
}

} // namespace

Summary runSprings(const Case& c, const RunCallback& callback, const RunOptions& options)
{
    if (options.from && c.run.integrator == IntegratorKind::Cvode)
        return refusedRun("the integrator cvode cannot continue a run: SUNDIALS keeps its state to itself");
    const DiskUnderSprings disk(c);
    if (std::string reason = reasonNotToStart(c, disk); !reason.empty()) return refusedRun(std::move(reason));
    const bool adaptiveOverDisk = disk.moves() && !hasFixedStep(c.run.integrator);
    if (adaptiveOverDisk && characteristic(c) && c.run.stepCheck) {
        std::vector<double> heights;
        Summary summary = runOnce(c, disk, c.run.step, callback, options, &heights);
        if (summary.status == RunStatus::Cancelled || !mayGraze(c, summary)) return summary;
        const std::string warning = otherMotion(c, disk, summary, heights, callback);
        if (!warning.empty()) summary.warnings.push_back(warning);
        return summary;
    }
    Summary summary = runOnce(c, disk, c.run.step, callback, options);
    if (c.run.stepCheck && hasFixedStep(c.run.integrator) && summary.status != RunStatus::Cancelled &&
        !summary.tail.empty()) {
        summary.stepCheck = checkStep(c, disk, summary, callback);
        if (!summary.stepCheck->sameEndState) summary.warnings.push_back(summary.stepCheck->message);
    }
    return summary;
}

} // namespace touchdown
