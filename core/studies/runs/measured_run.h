// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run of a case as studies need it: its summary, its samples of a few quantities, and the state in which it ends.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/simulation/recording/run_summary.h"
#include "core/work/parallel.h"
#include "core/work/work_done.h"

namespace touchdown {

class RunOutput;
struct Case;

/// The last part of a run, by which its end is judged [-].
inline constexpr double tailShare = 0.1;

/// Where a run ends: the contact of its verdict (core/simulation/recording/motion_verdict.h), where it has a valid end.
enum class EndKind : std::uint8_t {
    Flying,
    Contact,
    Intermittent, // in and out of contact
    Failed        // no valid end: the summary tells why
};
inline std::string_view name(EndKind kind)
{
    return kind == EndKind::Flying         ? name(Touch::Never)
           : kind == EndKind::Contact      ? name(Touch::Always)
           : kind == EndKind::Intermittent ? name(Touch::AtTimes)
                                           : "failed";
}
inline EndKind endKindOf(Touch touch)
{
    return touch == Touch::Never ? EndKind::Flying : touch == Touch::Always ? EndKind::Contact : EndKind::Intermittent;
}

struct EndState {
    EndKind kind = EndKind::Failed;
    double spacing = 0.0;              // mean of the spacing over the tail [m]
    double spread = 0.0;               // its standard deviation there [m]
    Motion motion = Motion::NotJudged; // of the verdict
};

struct MeasuredRun {
    Summary summary;
    std::vector<double> time;                 // of the samples [s]
    std::vector<std::vector<double>> columns; // of the quantities that were asked for, in their order [SI]
    EndState end;
    bool valid() const { return summary.status == RunStatus::Completed; }
};

/// The quantity that tells the spacing in a run of this case: "flying_height" of springs, else "minimum_spacing".
std::string_view spacingOf(const Case& c);

/// Runs the case without the check of its step and without maps, which cost time; keeps the samples of `quantities`,
/// names of recordedQuantities(c). `goOn` and `tell` may be empty; `tell` hears 1 at the end, however the run ends.
MeasuredRun measureRun(const Case& c, const std::vector<std::string>& quantities, const GoOn& goOn = {},
                       const RunOptions& options = {}, const ShareTeller& tell = {});
/// The same of the whole run, with its check and its maps, which `output` receives, all of it where the run was
/// not told to end. A problem of that ends the run.
MeasuredRun recordRun(const Case& c, const std::vector<std::string>& quantities, const GoOn& goOn,
                      const ShareTeller& tell, RunOutput& output);

/// Spacings that count as one [m].
inline constexpr double sameSpacing = 0.1e-9;
/// Two runs end in the same state: of one kind, their spacings differ by no more than `distance` [m] or both their
/// spreads, and these by no more than that or half of the wider one.
bool sameEnd(const EndState& a, const EndState& b, double distance = sameSpacing);
/// The same end state, or the same failure.
bool sameOutcome(const MeasuredRun& a, const MeasuredRun& b, double distance = sameSpacing);
/// "flies at 7 nm", "flies at 7 nm +- 0.14 nm" where it has not come to rest, "ends in contact at 1.59 nm", "bounces
/// about 6.1 nm +- 2.1 nm", "fails: chattering at 12 us". What follows +- is the standard deviation.
std::string outcomeText(const MeasuredRun& run);
/// The same of a valid end.
std::string endText(const EndState& end);
/// Whether this text begins with the motion of the end: "bounces", "vibrates in contact".
bool namesMotion(const EndState& end);

} // namespace touchdown
