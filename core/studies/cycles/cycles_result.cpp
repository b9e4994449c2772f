// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/cycles_result.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/case/contact_law.h"
#include "core/physics/contact/ono_yamane.h"

namespace touchdown {

namespace {

constexpr int looksAtWork = 65; // from one end of the range to the other
constexpr int halvingsOfZero = 50;

/// W of the case with a value of the parameter [J].
std::optional<double> workOfValue(const CyclesTask& task, double value)
{
    Case c = task.start;
    if (setFromNumber(c, task.parameter, value)) return {};
    return cycleWork(c);
}

/// Where W changes its sign, between a value with W < 0 and one without.
double zeroBetween(const CyclesTask& task, double negative, double other)
{
    for (int k = 0; k < halvingsOfZero; ++k) {
        const double middle = 0.5 * (negative + other);
        const std::optional<double> work = workOfValue(task, middle);
        (work && *work < 0.0 ? negative : other) = middle;
    }
    return other;
}

} // namespace

std::vector<ValueRange> creatingRanges(const CyclesTask& task)
{
    std::vector<ValueRange> ranges;
    std::optional<double> before; // the value before, where W is not negative
    bool creates = false;         // at the value before
    const double least = std::min(task.from, task.to), most = std::max(task.from, task.to);
    for (int i = 0; i < looksAtWork; ++i) {
        const double value = std::lerp(least, most, double(i) / (looksAtWork - 1));
        const std::optional<double> work = workOfValue(task, value);
        const bool now = work && *work < 0.0;
        if (now && !creates) ranges.push_back({before ? zeroBetween(task, value, *before) : value, value});
        if (now) ranges.back().upper = value;
        if (creates && work && !now) ranges.back().upper = zeroBetween(task, ranges.back().upper, value);
        creates = now;
        before = work && !now ? std::optional(value) : std::nullopt;
    }
    return ranges;
}

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
