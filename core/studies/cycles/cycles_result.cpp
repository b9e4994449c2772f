// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/cycles_result.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

std::vector<ValueRange> stableRanges(const std::vector<CycleBranch>& branches)
{
    std::vector<ValueRange> ranges;
    for (const CycleBranch& branch : branches) {
        bool before = false;
        for (const LimitCycle& point : branch.points) {
            if (point.stable() && before) {
                ranges.back().lower = std::min(ranges.back().lower, point.value);
                ranges.back().upper = std::max(ranges.back().upper, point.value);
            } else if (point.stable()) {
                ranges.push_back({point.value, point.value});
            }
            before = point.stable();
        }
    }
    return merged(std::move(ranges));
}

std::vector<CycleThreshold> thresholdsOf(const std::vector<CycleBranch>& branches)
{
    std::vector<CycleThreshold> found;
    for (std::size_t k = 0; k < branches.size(); ++k) {
        const std::vector<LimitCycle>& points = branches[k].points;
        for (const MarkedCycle& mark : branches[k].marks) {
            const std::size_t i = mark.point;
            if (mark.ends && mark.kind == CycleMark::PeriodDoubling)
                continue; // named with the cycle of half the period
            const LimitCycle* before = i > 0 ? &points[i - 1] : nullptr;
            const LimitCycle* after = i + 1 < points.size() ? &points[i + 1] : nullptr;
            const LimitCycle* stable = nullptr;
            if (mark.ends)
                stable = before != nullptr ? before : after;
            else if (before != nullptr && after != nullptr && before->stable() != after->stable())
                stable = before->stable() ? before : after;
            if (stable != nullptr && stable->stable()) found.push_back({mark, k});
        }
    }
    return found;
}

CycleAgreement agreementOf(const std::vector<BouncingRun>& runs)
{
    CycleAgreement agreement;
    for (const BouncingRun& run : runs) {
        if (!run.cycle || !run.cycle->stable()) continue;
        ++agreement.runs;
        agreement.frequency = std::max(agreement.frequency, std::abs(run.frequency / run.cycle->frequency() - 1.0));
        agreement.amplitude = std::max(agreement.amplitude, std::abs(run.amplitude() / run.cycle->amplitude() - 1.0));
    }
    return agreement;
}

} // namespace touchdown
