// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advice/reduced_models.h"

#include <algorithm>
#include <cmath>

#include "core/formats/units.h"
#include "core/physics/slider/minimum_spacing.h"
#include "core/simulation/equilibria/film_equilibria.h"
#include "core/simulation/small_motions/linear_motion.h"
#include "core/simulation/static_state/slider_body.h"
#include "core/studies/advice/advisor_study.h"
#include "core/studies/advice/pilot_run.h"
#include "core/studies/advice/spring_fit.h"

namespace touchdown {

namespace {

constexpr double restShare = 0.1;     // of a run, to see that it rests
constexpr double restSamples = 100.0; // at least

/// The end of a motion at rest.
TailEstimate atRest(double spacing)
{
    TailEstimate tail;
    tail.kind = EndKind::Flying;
    tail.mean = spacing;
    return tail;
}

void solveStatic(const Case& c, const GoOn& goOn, CandidateOutcome& outcome)
{
    Case still = c;
    still.steady.fixedAttitude = still.steady.stiffness = still.steady.sensitivities = still.steady.allEquilibria =
        false;
    const SteadyResult rest = steady(still, [&](const SteadyProgress&) { return !goOn || goOn(); });
    if (rest.status != SteadyStatus::Converged) {
        outcome.problem = rest.message.empty() ? "no static state was found" : rest.message;
        return;
    }
    outcome.tail = atRest(rest.minimumSpacing);
    outcome.found = c;
    outcome.found->steady.fixedAttitude = false;
    outcome.command = "steady";
}

/// A run that begins where the slider rests in contact, and stays there: it checks the rest, which is known without it.
Case startedAtRest(Case c, const Attitude& attitude)
{
    InitialCase& start = c.initial = InitialCase{};
    start.nominalTrailingEdgeHeight = attitude.height;
    start.pitch = attitude.pitch;
    start.roll = attitude.roll;
    start.branch = ContactBranch::TakeOff;
    c.run.duration *= restShare;
    c.run.sampleInterval = std::min(c.run.sampleInterval, c.run.duration / restSamples);
    return c;
}

void solveContactRest(const Case& c, double end, const GoOn& goOn, CandidateOutcome& outcome)
{
    Case flat = c;
    flat.diskSurface.kind = DiskSurfaceKind::Flat;
    const FilmEquilibria equilibria = filmEquilibria(flat, [&] { return !goOn || goOn(); });
    outcome.problem = equilibria.problem;
    const Equilibrium* nearest = nullptr;
    for (const Equilibrium& at : equilibria.found) {
        if (!at.touching || at.stability != Stability::Stable || at.lost > 0) continue;
        if (nearest == nullptr || std::abs(at.spacing - end) < std::abs(nearest->spacing - end)) nearest = &at;
    }
    if (nearest == nullptr) {
        if (outcome.problem.empty()) outcome.problem = "it has no stable place to rest in contact";
        return;
    }
    outcome.tail = atRest(nearest->spacing);
    outcome.tail.kind = EndKind::Contact;
    outcome.found = startedAtRest(std::move(flat), SliderBody(c, {}).attitude(nearest->q));
    outcome.command = "run";
}

void tellMotion(const Case& c, const LinearMotion& motion, CandidateOutcome& outcome)
{
    if (motion.status != SteadyStatus::Converged) {
        outcome.problem = motion.message.empty() ? "no static state was found" : motion.message;
        return;
    }
    const Recess recess(c.surface, c.slider.length, c.slider.width);
    const MinimumSpacing spacing(c.surface, recess);
    // The second half: its last fifth is the tail, all of it has the spectrum.
    const double interval = pilotInterval(c);
    const auto count = static_cast<std::size_t>(c.run.duration / interval * (1.0 + 1e-9)) + 1;
    SpacingSamples samples{interval, std::vector<double>(count), std::vector<char>(count, 0)};
    for (std::size_t k = count / 2; k < count; ++k)
        samples.spacing[k] = spacing.at(motion.at(static_cast<double>(k) * interval)).spacing;
    outcome.tail = estimateTail(samples, c.run.duration);
    const auto last = static_cast<std::ptrdiff_t>(std::max<std::size_t>(1, count / 10));
    const double lowest = *std::min_element(samples.spacing.end() - last, samples.spacing.end());
    if (!std::isfinite(outcome.tail.mean) || lowest <= 0.0)
        outcome.problem = motion.unstable() ? "a mode of the film grows, so that its motion does not stay small"
                                            : "the motion does not stay above the disk, so that it is not small";
}

void solveMotion(const Case& c, MotionParts parts, const GoOn& goOn, CandidateOutcome& outcome)
{
    tellMotion(c,
               linearMotion(
                   c, [&](const SteadyProgress&) { return !goOn || goOn(); }, parts),
               outcome);
}

void solveSprings(const Case& c, const GoOn& goOn, CandidateOutcome& outcome)
{
    SpringFit fit = fitSprings(c, goOn);
    outcome.problem = fit.problem;
    if (!fit.problem.empty()) return;
    outcome.remark =
        "fitted springs leave " + percent(fit.stiffnessLeft) + " of the film's stiffness matrix; modes at " +
        fewDigits(fit.springFrequency[0], "kHz", 3) + " and " + fewDigits(fit.springFrequency[1], "kHz", 3) +
        " (film: " + fewDigits(fit.filmFrequency[0], "kHz", 3) + ", " + fewDigits(fit.filmFrequency[1], "kHz", 3) +
        ") with damping ratios " + percent(fit.springDamping[0]) + " and " + percent(fit.springDamping[1]) +
        " (film: " + percent(fit.filmDamping[0]) + ", " + percent(fit.filmDamping[1]) + ")";
    const PilotRun run = pilotRun(fit.springs, {}, goOn);
    outcome.problem = run.problem;
    outcome.tail = estimateTail(run.samples, c.run.duration);
    outcome.found = std::move(fit.springs);
    outcome.command = "run";
}

void checkEnd(CandidateOutcome& outcome)
{
    if (outcome.problem.empty() && outcome.tail.kind == EndKind::Failed)
        outcome.problem = "it has too few samples to determine its end";
}

} // namespace

CandidateOutcome solveReduced(const Candidate& candidate, double end, const GoOn& goOn)
{
    CandidateOutcome outcome;
    outcome.model = candidate;
    const double begin = threadSeconds();
    if (candidate.kind == CandidateKind::Static) solveStatic(candidate.c, goOn, outcome);
    if (candidate.kind == CandidateKind::ContactRest) solveContactRest(candidate.c, end, goOn, outcome);
    if (candidate.kind == CandidateKind::WaveAnswer) solveMotion(candidate.c, MotionParts::Waves, goOn, outcome);
    if (candidate.kind == CandidateKind::SmallMotion) solveMotion(candidate.c, MotionParts::All, goOn, outcome);
    if (candidate.kind == CandidateKind::Springs) solveSprings(candidate.c, goOn, outcome);
    checkEnd(outcome);
    outcome.seconds = threadSeconds() - begin;
    return outcome;
}

CandidateOutcome describeSmallMotion(const Candidate& candidate, const LinearMotion& motion, double seconds)
{
    CandidateOutcome outcome;
    outcome.model = candidate;
    const double begin = threadSeconds();
    tellMotion(candidate.c, motion, outcome);
    checkEnd(outcome);
    outcome.seconds = seconds + threadSeconds() - begin;
    return outcome;
}

} // namespace touchdown
