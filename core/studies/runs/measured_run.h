// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run of a case as studies need it: its summary, its samples of a few quantities, and the state in which it ends.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/simulation/recording/run_summary.h"
#include "core/studies/runs/parallel.h"

namespace touchdown {

struct Case;

/// The last part of a run, by which its end is judged [-].
inline constexpr double tailShare = 0.1;

/// What acts between pad and disk at one sample. Ono & Yamane's menisci hold the pad where its asperities do not touch
/// any more; adhesion of surfaces reaches beyond contact.
class TouchColumns {
public:
    explicit TouchColumns(const Case& c);
    bool touches(const SampleBatch& batch, std::size_t i) const
    {
        return acts(contact_, batch, i) || (menisci_ && acts(adhesion_, batch, i));
    }
    /// From afar, too.
    bool acts(const SampleBatch& batch, std::size_t i) const
    {
        return acts(contact_, batch, i) || acts(adhesion_, batch, i);
    }

private:
    static bool acts(int column, const SampleBatch& batch, std::size_t i)
    {
        return column >= 0 && batch.columns[static_cast<std::size_t>(column)][i] != 0.0;
    }
    int contact_, adhesion_;
    bool menisci_;
};

/// Where a run ends, by the last tenth of its duration.
enum class EndKind : std::uint8_t {
    Flying,       // no contact at any sample
    Contact,      // contact at every sample
    Intermittent, // in and out of contact
    Failed        // no valid end: the summary tells why
};
inline std::string_view name(EndKind kind)
{
    constexpr std::array<std::string_view, 4> names{"flying", "contact", "in and out of contact", "failed"};
    static_assert(names.size() == static_cast<std::size_t>(EndKind::Failed) + 1);
    return names[static_cast<std::size_t>(kind)];
}

struct EndState {
    EndKind kind = EndKind::Failed;
    double spacing = 0.0; // mean of the spacing over the tail [m]
    double spread = 0.0;  // its standard deviation there [m]
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
/// names of recordedQuantities(c). `goOn` may be empty.
MeasuredRun measureRun(const Case& c, const std::vector<std::string>& quantities, const GoOn& goOn = {},
                       const RunOptions& options = {});

/// Spacings that count as one [m].
inline constexpr double sameSpacing = 0.1e-9;
/// Two runs end in the same state: of one kind, their spacings differ by no more than `distance` [m] or both their
/// spreads, and these by no more than that or half of the wider one.
bool sameEnd(const EndState& a, const EndState& b, double distance = sameSpacing);
/// The same end state, or the same failure.
bool sameOutcome(const MeasuredRun& a, const MeasuredRun& b, double distance = sameSpacing);
/// "flies at 7 nm", "flies at 7 nm +- 0.14 nm" where it has not come to rest, "ends in contact at 1.59 nm", "fails:
/// chattering at 12 us".
std::string outcomeText(const MeasuredRun& run);

} // namespace touchdown
