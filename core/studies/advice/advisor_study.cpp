// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advice/advisor_study.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "core/studies/advice/pilot_run.h"
#include "core/studies/advice/reduced_models.h"
#include "core/work/parallel.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

constexpr double knownTo = 0.25; // of what is allowed, for the pilot to end

void lower(std::atomic<double>& least, double value)
{
    for (double now = least; value < now && !least.compare_exchange_weak(now, value);) {
    }
}

class Advisor {
public:
    Advisor(const AdvisorTask& task, int jobs, const AdvisorTell& tell)
        : task_(task), jobs_(jobs), tell_(tell), begin_(wallClock())
    {}

    AdvisorResult advise()
    {
        const bool went = runFast() && runFull() && climb();
        if (went || result_.status == StudyStatus::Failed) return std::move(result_);
        if (result_.late && result_.full.answers() && result_.pilotTime > 0.0)
            return std::move(result_); // an answer, with what is missing
        result_.status = result_.late ? StudyStatus::Failed : StudyStatus::Cancelled;
        result_.message = result_.late ? "the budget was spent before the full model's end was known; give it more"
                                       : "stopped before all models were tried";
        return std::move(result_);
    }

private:
    bool tell(double share, const std::string& doing, const AdvisorResult* sofar = nullptr)
    {
        result_.late = result_.late || wallClock() - begin_ > task_.budget;
        return tell_(share, doing, sofar) && !result_.late;
    }

    /// The small motions, and the models that need nothing else. False: stopped.
    bool runFast()
    {
        const bool went = runParallel(
            1, 1, [&](std::size_t, const GoOn& goOn) { scene_ = sceneMotion(task_.start, goOn); },
            [&](std::size_t) { return tell(0.0, "small motions"); });
        if (!went) return false;
        result_.studySeconds += scene_.seconds;
        result_.growth = scene_.growth;
        result_.growthProblem = scene_.growthProblem;
        result_.roughPasses = scene_.roughPasses;
        const SteadyResult& rest = scene_.motion.steady;
        const double gridError = rest.discretisationError.minimumSpacing;
        if (rest.status == SteadyStatus::Converged && std::isfinite(gridError)) result_.gridError = gridError;
        std::vector<Candidate> fast;
        for (Candidate& candidate : candidatesOf(task_, rest.attitude.roll))
            (candidate.inTime()                             ? parts_
             : candidate.kind == CandidateKind::ContactRest ? rests_
                                                            : fast)
                .push_back(std::move(candidate));
        return runCandidates(fast, 0.05, 0.15) || leaveTheRest();
    }

    bool climb()
    {
        bool went = runCandidates(rests_, 0.6, 0.65);
        went = runCandidates(parts_, 0.65, 0.85, went);
        if (went)
            went = runSums();
        else
            leaveSums();
        choose();
        return went && (!task_.confirm || confirm());
    }

    /// Without several parts: the cheapest one that may be left out, and all others that may, too; where that is too
    /// much, one after the other as long as it stays within.
    bool runSums()
    {
        const CandidateOutcome* first = nullptr;
        std::vector<ModelPart> others; // the larger one of a family first
        for (const CandidateOutcome& candidate : result_.candidates) {
            if (candidate.model.kind != CandidateKind::Part) continue;
            if (candidate.within() && candidate.seconds < result_.full.seconds &&
                (first == nullptr || candidate.seconds < first->seconds))
                first = &candidate;
            if (candidate.within() || candidate.givenUp) others.push_back(candidate.model.parts[0]);
        }
        if (first == nullptr) return true;
        std::vector<ModelPart> left{first->model.parts[0]}, all = left;
        const auto holds = [](const std::vector<ModelPart>& parts, const ModelPart& part) {
            return std::ranges::find(parts, part.family, &ModelPart::family) != parts.end();
        };
        for (const ModelPart& part : others)
            if (!holds(all, part)) all.push_back(part);
        bool within = false;
        if (!runSum(all, within)) return false;
        for (const ModelPart& part : others) {
            if (within || holds(left, part)) continue;
            std::vector<ModelPart> more = left;
            more.push_back(part);
            bool enough = false;
            if (!runSum(more, enough)) return false;
            if (enough) left = more;
        }
        return true;
    }

    /// False: stopped. What has been tried is not tried again.
    bool runSum(const std::vector<ModelPart>& parts, bool& within)
    {
        const std::optional<Candidate> sum = sumOf(task_, parts);
        if (!sum || std::ranges::any_of(result_.candidates, [&](const CandidateOutcome& candidate) {
                return candidate.model.name == sum->name;
            }))
            return true;
        if (!runCandidates({*sum}, 0.85, 1.0)) return false;
        within = result_.candidates.back().within();
        return true;
    }

    /// The cheapest of the models so far that may be within is, and its errors are known to a factor of two.
    bool settles(const TailEstimate& full) const
    {
        const Allowance allowed = allowanceOf(full, task_);
        double least = std::numeric_limits<double>::infinity();
        bool settled = false;
        for (const CandidateOutcome& candidate : result_.candidates) {
            if (!candidate.answers() || candidate.seconds >= least) continue;
            const CandidateErrors errors = errorsOf(candidate.tail, full, task_);
            const Verdict verdict = verdictOn(errors, allowed);
            if (verdict != Verdict::Within && verdict != Verdict::NotKnown) continue;
            least = candidate.seconds;
            settled = verdict == Verdict::Within && isPrecise(errors.claimedMean(), errors.resolution, allowed.mean) &&
                      isPrecise(errors.claimedSpread(), errors.resolution, allowed.spread);
        }
        return settled;
    }

    bool runFull()
    {
        const double duration = task_.start.run.duration;
        double next = task_.pilot;
        bool known = false;
        const auto enough = [&](const SpacingSamples& samples) {
            if (!scene_.predicts()) return false;
            // At fixed times, independent of the number of samples per call, which depends on the clock.
            for (; !known && next < 1.0 && samples.reached() >= next * duration; next += 0.05) {
                const SpacingSamples part = samples.until(next * duration);
                const TailEstimate tail = estimateTail(part, duration, scene_.rates);
                const Allowance allowed = allowanceOf(tail, task_);
                known = tail.sameKind && tail.meanUncertainty <= knownTo * allowed.mean &&
                        tail.spreadUncertainty <= knownTo * allowed.spread && settles(tail);
                if (known) result_.pilotTime = part.reached();
            }
            return known && !task_.confirm;
        };
        std::atomic<double> share = 0.0;
        const bool went = runParallel(
            1, 1,
            [&](std::size_t, const GoOn& goOn) {
                const auto asked = [&](const SpacingSamples& samples) {
                    share = samples.reached() / duration;
                    return enough(samples);
                };
                full_ = pilotRun(task_.start, asked, goOn);
                if (full_.problem.empty() && !full_.samples.spacing.empty()) describeFull();
            },
            [&](std::size_t) { return tell(0.15 + 0.45 * share, "the full model"); });
        // Stopped on the way to confirm what is known does not undo it.
        if ((!went || full_.stopped) && !known && !full_.samples.reachEnd(duration)) {
            result_.full.problem = "it was not run far enough";
            return leaveTheRest();
        }
        if (!full_.problem.empty()) return fail(full_.problem);
        if (result_.full.tail.kind == EndKind::Failed || !std::isfinite(result_.full.tail.mean))
            return fail("its samples do not determine its end");
        for (CandidateOutcome& candidate : result_.candidates) judge(candidate);
        choose();
        return (went && !full_.stopped && tell(0.6, "models", &result_)) || leaveTheRest();
    }

    /// Where the study ends before them, and some might have been tried.
    void leaveSums()
    {
        std::vector<ModelPart> parts; // one of a family
        for (const Candidate& candidate : parts_)
            if (std::ranges::find(parts, candidate.parts[0].family, &ModelPart::family) == parts.end())
                parts.push_back(candidate.parts[0]);
        std::ptrdiff_t kept = 0; // none of all of them may be left out: there is no sum
        for (const CandidateOutcome& candidate : result_.candidates)
            kept += candidate.model.kind == CandidateKind::Part && !candidate.within();
        if (kept < std::ranges::ssize(parts_) && sumOf(task_, parts))
            result_.missing.push_back("film without several parts");
    }

    bool leaveTheRest()
    {
        for (const auto* candidates : {&rests_, &parts_})
            for (const Candidate& candidate : *candidates) result_.missing.push_back(candidate.name);
        leaveSums();
        return false;
    }

    bool fail(const std::string& why)
    {
        result_.status = StudyStatus::Failed;
        result_.message = "the full model has no answer to compare with: " + why;
        result_.full.problem = why;
        return false;
    }

    void describeFull()
    {
        const double duration = task_.start.run.duration;
        if (result_.pilotTime == 0.0 || result_.pilotTime > duration - full_.samples.interval)
            result_.pilotTime = full_.samples.reached();
        result_.pilotWhole = full_.samples.until(result_.pilotTime).reachEnd(duration);
        CandidateOutcome& full = result_.full;
        full.model = {CandidateKind::Full, "full model", "nothing", {}, task_.start};
        full.tail = estimateTail(full_.samples.until(result_.pilotTime), duration, scene_.rates);
        full.seconds = full_.secondsTo(duration);
        full.verdict = Verdict::Within;
        full.errors = errorsOf(full.tail, full.tail, task_);
        full.found = task_.start;
        full.command = "run";
        result_.allowed = allowanceOf(full.tail, task_);
        result_.studySeconds += full_.course.empty() ? 0.0 : full_.course.back().second;
        result_.contactActed = full_.contactActs;
    }

    /// What ended counts, also where it was stopped. Where it is not to `go` they are missing.
    bool runCandidates(const std::vector<Candidate>& candidates, double from, double to, bool go = true)
    {
        std::vector<CandidateOutcome> outcomes(candidates.size());
        std::vector<char> ended(candidates.size(), 0);
        std::vector<double> seconds(candidates.size(), 0.0);
        most_ = task_.all ? std::numeric_limits<double>::infinity() : mostSeconds();
        const bool went =
            go && runParallel(
                      candidates.size(), jobs_,
                      [&](std::size_t k, const GoOn& goOn) {
                          outcomes[k] = solve(candidates[k], goOn, seconds[k]);
                          ended[k] = goOn();
                      },
                      [&](std::size_t done) {
                          return tell(from + (to - from) * static_cast<double>(done) /
                                                 static_cast<double>(std::max<std::size_t>(1, candidates.size())),
                                      done < candidates.size() ? candidates[done].name : "models");
                      });
        for (std::size_t k = 0; k < candidates.size(); ++k) {
            result_.studySeconds += seconds[k];
            if (ended[k] != 0)
                result_.candidates.push_back(std::move(outcomes[k]));
            else
                result_.missing.push_back(candidates[k].name);
        }
        if (!went) return false;
        choose();
        return tell(to, "models", result_.pilotTime > 0.0 ? &result_ : nullptr);
    }

    /// That a model may take to be the advice.
    double mostSeconds() const
    {
        double most = result_.full.seconds;
        for (const CandidateOutcome& candidate : result_.candidates)
            if (candidate.within()) most = std::min(most, candidate.seconds);
        return most;
    }

    CandidateOutcome solve(const Candidate& candidate, const GoOn& goOn, double& seconds)
    {
        CandidateOutcome outcome;
        if (!candidate.inTime()) {
            const bool known =
                candidate.kind == CandidateKind::SmallMotion && candidate.c.film.nodes == task_.start.film.nodes;
            outcome = known ? describeSmallMotion(candidate, scene_.motion, scene_.seconds)
                            : solveReduced(candidate, result_.full.tail.mean, goOn);
            seconds = outcome.seconds - (known ? scene_.seconds : 0.0);
            judge(outcome);
            return outcome;
        }
        outcome.model = candidate;
        outcome.found = candidate.c;
        outcome.command = "run";
        // Contact that never acts changes nothing: no run is needed.
        const bool same = candidate.parts.size() == 1 &&
                          (candidate.parts[0].family == "contact" || candidate.parts[0].family == "adhesion") &&
                          !full_.contactActs;
        if (same) {
            outcome.tail = result_.full.tail;
            outcome.seconds = result_.full.seconds;
            outcome.remark =
                "only air acts on the slider in the whole pilot, so that leaving it out changes nothing there";
            judge(outcome);
            return outcome;
        }
        const double begin = threadSeconds();
        const PilotRun run = pilotRun(
            candidate.c,
            [&](const SpacingSamples&) {
                outcome.givenUp = threadSeconds() - begin > most_;
                return outcome.givenUp;
            },
            goOn);
        seconds = threadSeconds() - begin;
        outcome.problem = run.problem;
        outcome.seconds = run.secondsTo(task_.start.run.duration);
        outcome.tail = estimateTail(run.samples, task_.start.run.duration);
        if (outcome.answers() && outcome.tail.kind == EndKind::Failed)
            outcome.problem = "it has too few samples to determine its end";
        judge(outcome);
        if (outcome.within() && !task_.all) lower(most_, outcome.seconds);
        return outcome;
    }

    void judge(CandidateOutcome& candidate) const
    {
        if (!candidate.answers() || !result_.full.answers() || result_.pilotTime == 0.0) return;
        candidate.errors = errorsOf(candidate.tail, result_.full.tail, task_);
        candidate.verdict = verdictOn(candidate.errors, result_.allowed);
    }

    void choose()
    {
        double best = result_.full.seconds / worthwhile;
        result_.advice.reset();
        for (std::size_t k = 0; k < result_.candidates.size(); ++k) {
            const CandidateOutcome& candidate = result_.candidates[k];
            if (!candidate.within() || candidate.seconds >= best) continue;
            best = candidate.seconds;
            result_.advice = k;
        }
    }

    bool confirm()
    {
        const double duration = task_.start.run.duration;
        result_.fullEnd = estimateTail(full_.samples, duration);
        result_.fullSeconds = full_.secondsTo(duration);
        if (!result_.advice) return true;
        const CandidateOutcome& advice = result_.candidates[*result_.advice];
        TailEstimate end = advice.tail;
        result_.adviceSeconds = advice.seconds;
        if (advice.model.inTime()) {
            PilotRun run;
            const bool went = runParallel(
                1, 1, [&](std::size_t, const GoOn& goOn) { run = pilotRun(advice.model.c, {}, goOn); },
                [&](std::size_t) { return tell(1.0, "confirming the advice"); });
            if (!went) return false;
            end = estimateTail(run.samples, duration);
            if (!run.valid()) end.kind = EndKind::Failed;
            result_.adviceSeconds = run.secondsTo(duration);
            result_.studySeconds += result_.adviceSeconds;
        }
        result_.found = errorsOf(end, *result_.fullEnd, task_);
        return true;
    }

    const AdvisorTask& task_;
    int jobs_;
    const AdvisorTell& tell_;
    double begin_;
    SceneMotion scene_;
    std::vector<Candidate> rests_, parts_; // not yet solved
    std::atomic<double> most_ = 0.0;       // seconds, that a model in time may take
    PilotRun full_;
    AdvisorResult result_;
};

} // namespace

AdvisorResult advise(const AdvisorTask& task, int jobs, const AdvisorTell& tell)
{
    return Advisor(task, jobs, tell).advise();
}

} // namespace touchdown
