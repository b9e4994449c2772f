// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runs of a study of accuracy against speed: those that prove the reference, one of each setting for its errors, and the
// repeats for their times.
//
// Of the references the two of different families that lie closest are taken; their distance stands for what the reference itself does
// not know. Where even they part by more than the agreement, the trajectory is not determined: from there on, the horizon, errors
// mean nothing, and only what comes before is compared.
//
// Timed runs run alone, coarse settings first. The first run of a setting warms up and gives its errors; then, as long as the budget
// lasts, the others are repeated in turns, so that a disturbance does not meet all repeats of one.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/studies/precision_task.h"
#include "core/studies/study.h"

namespace touchdown {

struct ProvenReference {
    std::string problem;      // why there is none, in a sentence; "" where there is one
    std::string label, other; // the reference, and the run that lies closest to it
    MeasuredRun run;
    std::vector<TrajectoryError> uncertainty; // of the task's quantity, then of the others: over the samples that are compared
    std::optional<double> horizon;            // from which time on the trajectory is not determined [s]
    double apart = 0.0;       // largest distance of the two over the whole run [unit of the quantity]
    std::size_t samples = 0;  // that are compared
};

struct PrecisionPoint {
    std::size_t method = 0, setting = 0;
    bool ran = false;                    // false: the budget was spent
    Summary summary;
    EndState end;
    std::vector<TrajectoryError> errors; // as ProvenReference::uncertainty; empty of a run that failed otherwise than the reference
    PointKind kind = PointKind::Failed;
    std::vector<double> seconds;         // of the solver, of the timed runs in rising order [s]
    double work = 0.0;                   // right-hand sides, or films solved

    double fastest() const { return seconds.empty() ? 0.0 : seconds.front(); }
    double median() const;
};

struct PrecisionRuns {
    ProvenReference reference;
    std::vector<PrecisionPoint> points; // method by method
    bool complete = false;              // all first runs were made
    bool late = false;                  // the budget was spent before
};

/// Tells how far it is, 0 to 1, and what it does; false stops. `changed`: there is more to show than at the last call.
using RunsCallback = std::function<bool(double share, const std::string& doing, bool changed)>;

/// `runs` is filled as it goes. Returns false where the callback stopped it.
bool performRuns(const PrecisionTask& task, int jobs, PrecisionRuns& runs, const RunsCallback& callback);

} // namespace touchdown
