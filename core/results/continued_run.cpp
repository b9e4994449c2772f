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

/// The last one from which the run continues; null: none.
const StoredCheckpoint* checkpointFor(const StoredRun& stored, bool longer)
{
    const auto fits = [&](const StoredCheckpoint& checkpoint) { return checkpoint.at.extends || !longer; };
    const auto found = std::ranges::find_if(stored.checkpoints, fits);
    return found == stored.checkpoints.end() ? nullptr : &*found;
}

/// Why a run has no state from which it continues.
std::string reasonForNone(const StoredRun& stored, const Case& c, bool longer)
{
    if (c.model == ModelKind::Springs && c.run.integrator == IntegratorKind::Cvode)
        return "the integrator cvode stores no state";
    if (longer && c.model == ModelKind::Contact) return "the way of a pad fills its duration";
    if (longer && c.run.fieldSnapshots > 0 && c.model == ModelKind::Film && c.film.motion == FilmMotion::Full)
        return "its maps are spread over its duration (run.field_snapshots)";
    return stored.checkpoints.empty() ? "the file holds no state of it"
                                      : "the file holds no state of it before its end";
}

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
    if (stored.status != name(RunStatus::Completed) || longer) return {};
    if (!checkpointFor(stored, true))
        return "the run has completed, and cannot become longer, as " + reasonForNone(stored, before, true);
    return "the run has completed; with a longer run.duration, and all else as it is, it continues";
}

/// Another version of the program, or another machine; "" where both are these.
std::string otherOrigin(const StoredCheckpoint& checkpoint)
{
    if (checkpoint.version != TOUCHDOWN_VERSION)
        return "touchdown " + checkpoint.version + " began the run, this is " TOUCHDOWN_VERSION;
    if (checkpoint.machine != thisMachine())
        return "the run began on another machine (" + checkpoint.machine + "), this is " + thisMachine();
    return {};
}

} // namespace

ContinuedRun continueRun(const StoredRun& stored, const Case& before, const Case& now, OtherOrigin other)
{
    ContinuedRun run;
    const bool longer = now.run.duration > before.run.duration;
    run.problem = problemOf(stored, before, now);
    const StoredCheckpoint* checkpoint = checkpointFor(stored, longer);
    if (!run.problem.empty()) return run;
    if (!checkpoint) {
        run.startsAgain = reasonForNone(stored, now, longer);
        return run;
    }
    const std::string origin = otherOrigin(*checkpoint);
    if (checkpoint->layout != checkpointLayout) {
        run.problem = (origin.empty() ? std::string("another build of the program began the run") : origin) +
                      "; this one cannot read its state";
        return run;
    }
    if (stored.quantities != recordedQuantities(now)) {
        run.problem = "the file holds other quantities than a run of this program records";
        return run;
    }
    if (!origin.empty() && other == OtherOrigin::Refused) {
        run.problem = origin + "; its last digits may differ";
        run.isOfOthers = true;
        return run;
    }
    run.remark = stored.continued;
    if (!origin.empty())
        run.remark += (run.remark.empty() ? "" : "; ") + origin + "; it was continued at " +
                      fewDigitsOfTime(checkpoint->at.time, 6);
    run.from = std::make_shared<const StoredCheckpoint>(*checkpoint);
    for (const StoredCheckpoint& each : stored.checkpoints)
        if (each.at.time < checkpoint->at.time) run.states.push_back(std::make_shared<const StoredCheckpoint>(each));
    run.states.push_back(run.from);
    return run;
}

void cutTo(const StoredCheckpoint& checkpoint, SampleBatch& samples, std::vector<FieldSnapshot>& fields)
{
    samples.time.resize(checkpoint.samples);
    for (std::vector<double>& column : samples.columns) column.resize(checkpoint.samples);
    std::vector<std::size_t> left = checkpoint.snapshots;
    std::erase_if(fields, [&](const FieldSnapshot& snapshot) {
        if (snapshot.set >= left.size() || left[snapshot.set] == 0) return true;
        --left[snapshot.set];
        return false;
    });
}

} // namespace touchdown
