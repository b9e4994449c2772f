// SPDX-License-Identifier: GPL-3.0-or-later
//
// The error of a model's end against the full model's end, how much of it is claimed, and whether it is allowed.
//
// Errors: of the mean spacing over the last tenth, and of its standard deviation there. Allowed are
//
//   of the mean    tolerance times the mean, or times the spread where that is larger (a bounce)
//   of the spread  spread_tolerance times the spread, or times `tolerance` times the mean where that is larger
//
// and at least twice what one step of the full model may displace the slider by. A model must also end in the same
// state (flying, in contact, in and out of it); where the spread is larger than tolerance times the mean and than that
// displacement, its largest peak must lie at the same frequency.
//
// An error e that is known to u lies between e - u and e + u. If u <= e/2, e is claimed: it is known to a factor of
// two. Otherwise the claim is that the error is below e + u.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "core/studies/advice/tail_estimate.h"

namespace touchdown {

struct AdvisorTask;

struct Claim {
    double value = 0.0; // [m]; infinite where nothing is known
    bool bound = false; // it is below the value
};
/// What is below `resolution` is not claimed otherwise than as below it.
Claim claimOf(double error, double uncertainty, double resolution);
/// Known to a factor of two, or below the resolution or a tenth of what is allowed.
bool isPrecise(const Claim& claim, double resolution, double allowed);
/// Within a factor of two, or below the bound.
bool confirms(const Claim& claim, double found);
/// "0.13 nm", "< 0.01 nm", "not known".
std::string textOf(const Claim& claim);

struct CandidateErrors {
    double mean = 0.0, spread = 0.0;                       // [m]
    double meanUncertainty = 0.0, spreadUncertainty = 0.0; // of what the pilot predicts; infinite: not known [m]
    double resolution = 0.0;                               // what the full model's steps leave open [m]
    bool sameEnd = true, samePeak = true;
    bool endKnown = true; // else the full model may still end otherwise
    Claim claimedMean() const { return claimOf(mean, meanUncertainty, resolution); }
    Claim claimedSpread() const { return claimOf(spread, spreadUncertainty, resolution); }
};

struct Allowance {
    double mean = 0.0, spread = 0.0;             // [m]
    double step = 0.0;                           // twice what one step may displace the slider by [m]
    double wantedMean = 0.0, wantedSpread = 0.0; // without that [m]
    bool widened() const { return mean > wantedMean || spread > wantedSpread; }
};
Allowance allowanceOf(const TailEstimate& full, const AdvisorTask& task);

/// Errors of a model's end, which is known, against the full model's, which may be predicted.
CandidateErrors errorsOf(const TailEstimate& candidate, const TailEstimate& full, const AdvisorTask& task);

enum class Verdict : std::uint8_t { Within, TooFar, AnotherEnd, AnotherPeak, NotKnown };
inline std::string_view name(Verdict verdict)
{
    constexpr std::array<std::string_view, 5> names{"within", "too far", "another end", "another peak", "not known"};
    static_assert(names.size() == static_cast<std::size_t>(Verdict::NotKnown) + 1);
    return names[static_cast<std::size_t>(verdict)];
}
Verdict verdictOn(const CandidateErrors& errors, const Allowance& allowed);

} // namespace touchdown
