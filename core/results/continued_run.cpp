// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/continued_run.h"

#include <algorithm>
#include <utility>

#include "core/case/case_difference.h"
#include "core/case/integrator_kind.h"
#include "core/formats/units.h"
#include "core/simulation/run.h"

namespace touchdown {
namespace {

std::string problemOf(const StoredRun& stored, const Case& before, Case now)
{
    if (stored.status == name(RunStatus::Failed) || stored.status == name(RunStatus::Diverged))
        return "the run has ended by itself: " + stored.message;
    if (now.run.duration < before.run.duration)
        return "run.duration is shorter than that of the run, " + formatQuantity(before.run.duration, "ms") +
               "; a run continues to the same end or a later one";
    const bool longer = now.run.duration > before.run.duration;
    now.run.duration = before.run.duration;
    now.folder = before.folder;
    if (!(now == before)) {
        const std::vector<CaseChange> changes = caseChanges(before, now);
        return (changes.empty() ? std::string("the case") : changes.front().key) +
               " is not that of the run; only run.duration may change";
    }
    if (stored.status == name(RunStatus::Completed) && !longer)
        return "the run has completed; with a longer run.duration it continues";
    return {};
}

/// The last one from which the run continues; null: none.
const StoredCheckpoint* checkpointFor(const StoredRun& stored, bool longer)
{
    const auto fits = [&](const StoredCheckpoint& checkpoint) {
        return checkpoint.layout == checkpointLayout && (checkpoint.at.extends || !longer);
    };
    const auto found = std::ranges::find_if(stored.checkpoints, fits);
    return found == stored.checkpoints.end() ? nullptr : &*found;
}

} // namespace

ContinuedRun continueRun(const StoredRun& stored, const Case& before, const Case& now, OtherOrigin other)
{
    ContinuedRun run;
    const bool longer = now.run.duration > before.run.duration;
    run.problem = problemOf(stored, before, now);
    const StoredCheckpoint* checkpoint = checkpointFor(stored, longer);
    if (!run.problem.empty() || !checkpoint) return run;
    if (stored.quantities != recordedQuantities(now)) {
        run.problem = "the file holds other quantities than a run of this program records";
        return run;
    }
    std::string origin;
    if (stored.softwareVersion != TOUCHDOWN_VERSION)
        origin = "touchdown " + stored.softwareVersion + " began the run, this is " TOUCHDOWN_VERSION;
    else if (checkpoint->machine != thisMachine())
        origin = "the run began on another machine (" + checkpoint->machine + "), this is " + thisMachine();
    if (!origin.empty() && other == OtherOrigin::Refused) {
        run.problem = origin + "; its last digits may differ";
        run.isOfOthers = true;
        return run;
    }
    if (!origin.empty()) run.remark = origin + "; it was continued at " + fewDigitsOfTime(checkpoint->at.time, 6);
    run.from = std::make_shared<const StoredCheckpoint>(*checkpoint);
    return run;
}

void cutTo(const StoredCheckpoint& checkpoint, SampleBatch& samples, std::vector<FieldSnapshot>& fields)
{
    samples.time.resize(checkpoint.samples);
    for (std::vector<double>& column : samples.columns) column.resize(checkpoint.samples);
    std::vector<std::size_t> left = checkpoint.snapshots;
    std::erase_if(fields, [&](const FieldSnapshot& snapshot) {
        if (left[snapshot.set] == 0) return true;
        --left[snapshot.set];
        return false;
    });
}

} // namespace touchdown
