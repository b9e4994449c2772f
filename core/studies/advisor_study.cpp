// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advisor_study.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "core/simulation/linear_motion.h"
#include "core/studies/parallel.h"
#include "core/studies/pilot_run.h"
#include "core/studies/reduced_models.h"

namespace touchdown {

namespace {

constexpr double knownTo = 0.25;   // of what is allowed, for the pilot to end
constexpr double mostGrowth = 0.3;   // e-folds of a mode over the run, beyond which a part does not foretell its end
constexpr double worthwhile = 1.2; // a model must be so many times faster to be advised

/// Twice what one step may displace the slider by: what the full model itself leaves open [m].
double ownError(const AdvisorTask& task) { return 2.0 * (task.start.run.steps == StepControl::Adaptive ? task.start.run.stepError : 1e-12); }

double allowedMeanOf(const TailEstimate& full, const AdvisorTask& task)
{
    return std::max(task.tolerance * std::max(std::abs(full.mean), full.spread), ownError(task));
}
double allowedSpreadOf(const TailEstimate& full, const AdvisorTask& task)
{
    return std::max(task.spreadTolerance * std::max(full.spread, task.tolerance * std::abs(full.mean)), ownError(task));
}

class Advisor {
public:
    Advisor(const AdvisorTask& task, int jobs, const std::function<bool(double, const std::string&)>& tell)
        : task_(task), jobs_(jobs), tell_(tell)
    {
    }

    AdvisorResult advise()
    {
        if (runFull() && climb()) return std::move(result_);
        if (result_.status == StudyStatus::Completed) stop();
        return std::move(result_);
    }

private:
    /// False: stopped.
    bool climb()
    {
        if (!runRungs(ladderOf(task_, rest_.roll), 0.5, 0.85)) return false;
        std::vector<LadderPart> parts;
        for (const RungOutcome& rung : result_.rungs)
            if (rung.rung.kind == RungKind::Part && rung.within && rung.seconds < result_.full.seconds) parts.push_back(rung.rung.parts[0]);
        if (!runRungs(sumsOf(task_, parts), 0.85, 1.0)) return false;
        choose();
        return !task_.confirm || confirm();
    }

    void stop()
    {
        result_.status = StudyStatus::Cancelled;
        result_.message = "stopped before all models were tried";
    }

    bool runFull()
    {
        const double duration = task_.start.run.duration;
        double next = task_.pilot;
        const auto enough = [&](const SpacingSamples& samples) {
            // It may still do what it has not done yet.
            if (result_.growth > mostGrowth || !result_.growthProblem.empty()) return false;
            // At the same times however many samples come at once, which hangs on the clock.
            for (; result_.pilotTime == 0.0 && next < 1.0 && samples.reached() >= next * duration; next += 0.05) {
                const SpacingSamples part = samples.until(next * duration);
                const TailEstimate tail = estimateTail(part, duration, rates_);
                const bool known = tail.sameKind && tail.meanUncertainty <= knownTo * allowedMeanOf(tail, task_) &&
                                   tail.spreadUncertainty <= knownTo * allowedSpreadOf(tail, task_);
                if (known) result_.pilotTime = part.reached();
            }
            return result_.pilotTime > 0.0 && !task_.confirm;
        };
        std::atomic<double> share = 0.0;
        const bool went = runParallel(1, 1, [&](std::size_t, const GoOn& goOn) {
            const auto asked = [&](const SpacingSamples& samples) {
                share = samples.reached() / duration;
                return enough(samples);
            };
            findRates(goOn);
            full_ = pilotRun(task_.start, asked, goOn);
            if (full_.valid()) describeFull();
        }, [&](std::size_t) { return tell_(0.5 * share, "the full model"); });
        if (!went || full_.stopped) return false;
        if (!full_.valid()) {
            result_.status = StudyStatus::Failed;
            result_.message = "the full model gives no answer to compare with: " + full_.problem;
            return false;
        }
        if (result_.full.tail.kind == EndKind::Failed || !std::isfinite(result_.full.tail.mean)) {
            result_.status = StudyStatus::Failed;
            result_.message = "the full model gives no answer to compare with: its samples do not tell its end";
            return false;
        }
        return true;
    }

    void describeFull()
    {
        const double duration = task_.start.run.duration;
        if (result_.pilotTime == 0.0 || result_.pilotTime > duration - full_.samples.interval) result_.pilotTime = full_.samples.reached();
        RungOutcome& full = result_.full;
        full.rung = {RungKind::Full, "full model", "nothing", {}, task_.start};
        full.samples = full_.samples.until(result_.pilotTime);
        foretell(full);
        full.seconds = full_.secondsTo(duration);
        full.within = true;
        full.errors.meanResolution = std::max(full.tail.meanUncertainty, ownError(task_));
        full.errors.spreadResolution = std::max(full.tail.spreadUncertainty, ownError(task_));
        result_.pilotSeconds = full_.secondsTo(result_.pilotTime);
        result_.studySeconds += full_.course.empty() ? 0.0 : full_.course.back().second;
        result_.contactActed = full_.contactActs;
    }

    bool pilotIsWhole() const { return result_.pilotTime >= task_.start.run.duration - 0.5 * full_.samples.interval; }

    /// The end of a model in time, by its samples up to the pilot's time and to less of it.
    void foretell(RungOutcome& rung) const
    {
        const double duration = task_.start.run.duration;
        rung.tail = estimateTail(rung.samples, duration, rates_);
        if (pilotIsWhole()) return;
        constexpr std::array shares{0.9, 0.8};
        for (std::size_t k = 0; k < shares.size(); ++k)
            rung.earlier[k] = estimateTail(rung.samples.until(shares[k] * result_.pilotTime), duration, rates_);
    }

    /// The static state, and the rates at which the scene rings about it; without them ends are foretold otherwise.
    void findRates(const GoOn& goOn)
    {
        const double begin = threadSeconds();
        const LinearMotion motion = linearMotion(task_.start, [&](const SteadyProgress&) { return goOn(); });
        result_.studySeconds += threadSeconds() - begin;
        if (motion.modes.empty()) result_.growthProblem = motion.message.empty() ? "no static state was found" : motion.message;
        rest_ = motion.steady.attitude;
        if (motion.steady.status == SteadyStatus::Converged) result_.gridError = motion.steady.discretisationError.minimumSpacing;
        for (const MotionTerm& mode : motion.modes) {
            rates_.push_back({mode.rate, false});
            result_.growth = std::max(result_.growth, mode.rate.real() * task_.start.run.duration);
        }
        // Air that creeps out of the cavity takes about as long as the disk drags it along under the slider.
        const double speed = std::abs(task_.start.disk.speed) * task_.start.disk.radius;
        if (!rates_.empty() && speed > 0.0) rates_.push_back({-speed / task_.start.slider.length, false});
        for (const MotionTerm& wave : motion.waves) rates_.push_back({wave.rate, true});
    }

    bool runRungs(const std::vector<Rung>& rungs, double from, double to)
    {
        std::vector<RungOutcome> outcomes(rungs.size());
        std::vector<double> seconds(rungs.size(), 0.0);
        const bool went = runParallel(rungs.size(), jobs_, [&](std::size_t k, const GoOn& goOn) {
            outcomes[k] = solve(rungs[k], goOn, seconds[k]);
        }, [&](std::size_t done) {
            return tell_(from + (to - from) * static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(1, rungs.size())),
                         done < rungs.size() ? rungs[done].name : "the ladder");
        });
        if (!went) return false;
        for (std::size_t k = 0; k < rungs.size(); ++k) {
            result_.studySeconds += seconds[k];
            judge(outcomes[k]);
            result_.rungs.push_back(std::move(outcomes[k]));
        }
        return true;
    }

    RungOutcome solve(const Rung& rung, const GoOn& goOn, double& seconds)
    {
        if (rung.kind != RungKind::Part && rung.kind != RungKind::Sum) {
            RungOutcome outcome = solveReduced(rung, result_.full.tail.mean, goOn);
            seconds = outcome.seconds;
            return outcome;
        }
        RungOutcome outcome{.rung = rung, .problem = {}, .remark = {}, .tail = {}, .earlier = {}, .samples = {}, .errors = {}, .found = rung.c};
        // Contact that never acts changes nothing: no run can tell more.
        const bool same = rung.parts.size() == 1 && (rung.parts[0].family == "contact" || rung.parts[0].family == "adhesion") && !full_.contactActs;
        if (same) {
            outcome.tail = result_.full.tail;
            outcome.earlier = result_.full.earlier;
            outcome.samples = result_.full.samples;
            outcome.seconds = result_.full.seconds;
            outcome.remark = "nothing acts on the slider but air in the whole pilot, so that leaving it out changes nothing there";
            return outcome;
        }
        const double wanted = result_.pilotTime;
        PilotRun run = pilotRun(rung.c, [wanted](const SpacingSamples& samples) { return samples.reached() >= wanted; }, goOn);
        seconds = run.course.empty() ? 0.0 : run.course.back().second;
        outcome.problem = run.problem;
        outcome.samples = run.samples.until(wanted);
        foretell(outcome);
        if (outcome.valid() && outcome.tail.kind == EndKind::Failed) outcome.problem = "it has too few samples to tell its end";
        outcome.seconds = run.secondsTo(task_.start.run.duration);
        return outcome;
    }

    void judge(RungOutcome& rung) const
    {
        if (!rung.valid()) return;
        const TailEstimate& full = result_.full.tail;
        RungErrors& errors = rung.errors;
        errors = compare(rung.tail, full);
        errors.meanResolution = full.meanUncertainty;
        errors.spreadResolution = full.spreadUncertainty;
        if (!rung.samples.spacing.empty() && !pilotIsWhole()) {
            // Both by the same estimate of as much: how it moves by itself does not count.
            errors.meanResolution = errors.spreadResolution = 0.0;
            for (std::size_t k = 0; k < rung.earlier.size(); ++k) {
                const RungErrors before = compare(rung.earlier[k], result_.full.earlier[k]);
                errors.meanResolution = std::max(errors.meanResolution, std::abs(before.mean - errors.mean));
                errors.spreadResolution = std::max(errors.spreadResolution, std::abs(before.spread - errors.spread));
            }
        }
        errors.meanResolution = std::max(errors.meanResolution, ownError(task_));
        errors.spreadResolution = std::max(errors.spreadResolution, ownError(task_));
        rung.within = errors.sameEnd && errors.samePeak && errors.claimedMean() <= allowedMeanOf(full, task_) &&
                      errors.claimedSpread() <= allowedSpreadOf(full, task_);
    }

    RungErrors compare(const TailEstimate& rung, const TailEstimate& full) const
    {
        RungErrors errors;
        errors.mean = std::abs(rung.mean - full.mean);
        errors.spread = std::abs(rung.spread - full.spread);
        errors.sameEnd = rung.kind == full.kind;
        if (full.spread > task_.tolerance * std::abs(full.mean) && full.peakFrequency > 0.0)
            errors.samePeak = std::abs(rung.peakFrequency - full.peakFrequency) <=
                              std::max({rung.resolution, full.resolution, task_.spreadTolerance * full.peakFrequency});
        return errors;
    }

    void choose()
    {
        double best = result_.full.seconds / worthwhile;
        for (std::size_t k = 0; k < result_.rungs.size(); ++k) {
            const RungOutcome& rung = result_.rungs[k];
            if (!rung.valid() || !rung.within || rung.seconds >= best) continue;
            best = rung.seconds;
            result_.advice = k;
        }
    }

    bool confirm()
    {
        const double duration = task_.start.run.duration;
        result_.fullEnd = estimateTail(full_.samples, duration);
        result_.fullSeconds = full_.secondsTo(duration);
        if (!result_.advice) return true;
        const RungOutcome& advice = result_.rungs[*result_.advice];
        TailEstimate end = advice.tail;
        result_.adviceSeconds = advice.seconds;
        if (advice.rung.kind == RungKind::Part || advice.rung.kind == RungKind::Sum) {
            PilotRun run;
            const bool went = runParallel(1, 1, [&](std::size_t, const GoOn& goOn) { run = pilotRun(advice.rung.c, {}, goOn); },
                                          [&](std::size_t) { return tell_(1.0, "confirming the advice"); });
            if (!went) return false;
            end = estimateTail(run.samples, duration);
            if (!run.valid()) end.kind = EndKind::Failed;
            result_.adviceSeconds = run.secondsTo(duration);
            result_.studySeconds += result_.adviceSeconds;
        }
        result_.found = compare(end, *result_.fullEnd);
        return true;
    }

    const AdvisorTask& task_;
    int jobs_;
    const std::function<bool(double, const std::string&)>& tell_;
    std::vector<RingingRate> rates_;
    Attitude rest_; // the static state, where there is one
    PilotRun full_;
    AdvisorResult result_;
};

} // namespace

double AdvisorResult::allowedMean(const AdvisorTask& task) const { return allowedMeanOf(full.tail, task); }
double AdvisorResult::allowedSpread(const AdvisorTask& task) const { return allowedSpreadOf(full.tail, task); }

AdvisorResult advise(const AdvisorTask& task, int jobs, const std::function<bool(double, const std::string&)>& tell)
{
    return Advisor(task, jobs, tell).advise();
}

} // namespace touchdown
