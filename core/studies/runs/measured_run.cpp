// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/measured_run.h"

#include <algorithm>
#include <cmath>

#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "core/numerics/moments.h"
#include "core/results/run_output.h"
#include "core/simulation/recording/last_sample.h"
#include "core/simulation/run.h"

namespace touchdown {

std::string_view spacingOf(const Case& c)
{
    return c.model == ModelKind::Springs ? "flying_height" : "minimum_spacing";
}

namespace {

/// Runs are compared at times at which all have a sample. A run that failed ends at a time of its own.
void dropSampleBetween(MeasuredRun& run, double interval)
{
    if (run.time.empty() || !isBetweenSamples(run.time.back(), interval)) return;
    run.time.pop_back();
    for (std::vector<double>& column : run.columns)
        if (!column.empty()) column.pop_back();
}

/// `output` may be null.
MeasuredRun measure(const Case& c, const std::vector<std::string>& quantities, const GoOn& goOn,
                    const RunOptions& options, const ShareTeller& tell, RunOutput* output)
{
    const std::vector<Quantity> all = recordedQuantities(c);
    std::vector<int> columns;
    for (const std::string& quantity : quantities) columns.push_back(findQuantity(all, quantity));
    const int spacing = findQuantity(all, spacingOf(c));
    const double tailBegin = (1.0 - tailShare) * c.run.duration;

    MeasuredRun run;
    run.columns.resize(quantities.size());
    std::vector<double> tail; // of the spacing
    run.summary = touchdown::run(
        c,
        [&](const RunUpdate& update) {
            const SampleBatch& batch = update.samples;
            run.time.insert(run.time.end(), batch.time.begin(), batch.time.end());
            for (std::size_t i = 0; i < columns.size(); ++i) {
                if (columns[i] < 0) continue;
                const std::vector<double>& values = batch.columns[static_cast<std::size_t>(columns[i])];
                run.columns[i].insert(run.columns[i].end(), values.begin(), values.end());
            }
            for (std::size_t i = 0; i < batch.size(); ++i) {
                if (batch.time[i] < tailBegin || spacing < 0) continue;
                // The last sample follows the previous one by less than an interval.
                if (!tail.empty() && isBetweenSamples(batch.time[i], c.run.sampleInterval)) continue;
                tail.push_back(batch.columns[static_cast<std::size_t>(spacing)][i]);
            }
            if (tell) tell(update.time / c.run.duration);
            if (output != nullptr) output->add(update);
            return (!goOn || goOn()) && (output == nullptr || output->problem().empty());
        },
        options);
    if (tell) tell(1.0);
    if (output != nullptr && run.summary.status != RunStatus::Cancelled) output->finish(run.summary);
    if (!run.valid()) dropSampleBetween(run, c.run.sampleInterval);
    if (!run.valid() || tail.empty()) return run;
    const Moments moments = momentsOf(tail);
    run.end = {endKindOf(run.summary.verdict.touch), moments.mean, moments.deviation, run.summary.verdict.motion};
    return run;
}

} // namespace

MeasuredRun measureRun(const Case& given, const std::vector<std::string>& quantities, const GoOn& goOn,
                       const RunOptions& options, const ShareTeller& tell)
{
    Case c = given;
    c.run.stepCheck = false;
    c.run.fieldSnapshots = 0;
    return measure(c, quantities, goOn, options, tell, nullptr);
}

MeasuredRun recordRun(const Case& c, const std::vector<std::string>& quantities, const GoOn& goOn,
                      const ShareTeller& tell, RunOutput& output)
{
    return measure(c, quantities, goOn, {}, tell, &output);
}

bool sameEnd(const EndState& a, const EndState& b, double distance)
{
    if (a.kind != b.kind) return false;
    if (a.kind == EndKind::Failed) return true;
    const double wider = std::max(a.spread, b.spread);
    return std::abs(a.spread - b.spread) <= std::max(distance, 0.5 * wider) &&
           std::abs(a.spacing - b.spacing) <= std::max(distance, a.spread + b.spread);
}

bool sameOutcome(const MeasuredRun& a, const MeasuredRun& b, double distance)
{
    if (a.valid() != b.valid()) return false;
    return a.valid() ? sameEnd(a.end, b.end, distance) : a.summary.failure == b.summary.failure;
}

std::string outcomeText(const MeasuredRun& run)
{
    return run.valid() ? endText(run.end) : "fails: " + run.summary.message;
}

bool namesMotion(const EndState& end)
{
    return (end.kind == EndKind::Contact && end.motion == Motion::Vibrates) ||
           (end.kind == EndKind::Intermittent && end.motion == Motion::Bounces);
}

std::string endText(const EndState& end)
{
    constexpr double rest = 0.1 * sameSpacing;
    const std::string at =
        fewDigits(end.spacing, "nm", 3) + (end.spread > rest ? " +- " + fewDigits(end.spread, "nm") : "");
    switch (end.kind) {
    case EndKind::Flying: return "flies at " + at;
    case EndKind::Contact: return std::string(namesMotion(end) ? name(end.motion) : "ends in contact") + " at " + at;
    case EndKind::Intermittent:
        return std::string(namesMotion(end) ? name(end.motion) : "goes in and out of contact") + " about " + at;
    case EndKind::Failed: break;
    }
    return "has no end";
}

} // namespace touchdown
