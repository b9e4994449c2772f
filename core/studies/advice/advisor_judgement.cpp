// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advice/advisor_judgement.h"

#include <algorithm>
#include <cmath>

#include "core/formats/units.h"
#include "core/studies/advice/advisor_candidates.h"

namespace touchdown {

namespace {

constexpr double precise = 0.1; // of what is allowed: below it a bound says enough

} // namespace

Claim claimOf(double error, double uncertainty, double resolution)
{
    if (uncertainty <= 0.5 * error && error >= resolution) return {error, false};
    return {std::max(error + uncertainty, resolution), true};
}

bool isPrecise(const Claim& claim, double resolution, double allowed)
{
    return !claim.bound || claim.value <= std::max(resolution, precise * allowed);
}

bool confirms(const Claim& claim, double found)
{
    if (claim.bound) return found <= claim.value;
    return found <= 2.0 * claim.value && claim.value <= 2.0 * found;
}

std::string textOf(const Claim& claim)
{
    if (!std::isfinite(claim.value)) return "not known";
    return (claim.bound ? "< " : "") + fewDigits(claim.value, "nm");
}

Allowance allowanceOf(const TailEstimate& full, const AdvisorTask& task)
{
    Allowance allowed;
    const RunCase& run = task.start.run;
    allowed.step = 2.0 * (run.steps == StepControl::Adaptive ? run.stepError : 1e-12);
    allowed.wantedMean = task.tolerance * std::max(std::abs(full.mean), full.spread);
    allowed.wantedSpread = task.spreadTolerance * std::max(full.spread, task.tolerance * std::abs(full.mean));
    allowed.mean = std::max(allowed.wantedMean, allowed.step);
    allowed.spread = std::max(allowed.wantedSpread, allowed.step);
    return allowed;
}

CandidateErrors errorsOf(const TailEstimate& candidate, const TailEstimate& full, const AdvisorTask& task)
{
    CandidateErrors errors;
    errors.mean = std::abs(candidate.mean - full.mean);
    errors.spread = std::abs(candidate.spread - full.spread);
    errors.resolution = allowanceOf(full, task).step;
    errors.sameEnd = candidate.kind == full.kind;
    errors.endKnown = full.sameKind;
    if (full.spread > std::max(task.tolerance * std::abs(full.mean), errors.resolution) && full.peakFrequency > 0.0)
        errors.samePeak = std::abs(candidate.peakFrequency - full.peakFrequency) <=
                          std::max({candidate.resolution, full.resolution, task.spreadTolerance * full.peakFrequency});
    errors.meanUncertainty = full.meanUncertainty;
    errors.spreadUncertainty = full.spreadUncertainty;
    return errors;
}

Verdict verdictOn(const CandidateErrors& errors, const Allowance& allowed)
{
    if (!errors.endKnown) return Verdict::NotKnown;
    if (!errors.sameEnd) return Verdict::AnotherEnd;
    if (errors.mean - errors.meanUncertainty > allowed.mean ||
        errors.spread - errors.spreadUncertainty > allowed.spread)
        return Verdict::TooFar;
    if (!errors.samePeak) return Verdict::AnotherPeak;
    const bool within = errors.mean + errors.meanUncertainty <= allowed.mean &&
                        errors.spread + errors.spreadUncertainty <= allowed.spread;
    return within ? Verdict::Within : Verdict::NotKnown;
}

} // namespace touchdown
