// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runs of a study of accuracy against speed: those that prove the reference, one of each setting for its errors,
// and the repeats for their times.
//
// Reference runs get a share of the budget; those that have not ended by then prove nothing.
//
// Timed runs run alone, coarse settings first. The first run of a setting warms up and gives its errors; then, as long
// as the budget lasts, the others are repeated alternately, so that a disturbance does not meet all repeats of one.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/numerics/moments.h"
#include "core/studies/runs/proven_reference.h"
#include "core/studies/runs/trajectory_error.h"
#include "core/studies/study/study.h"

namespace touchdown {

struct PrecisionTask;

struct PrecisionPoint {
    std::size_t method = 0, setting = 0;
    bool ran = false; // false: the budget was spent
    Summary summary;
    EndState end;
    std::vector<TrajectoryError>
        errors; // of the task's quantity, then of the others; empty of a run that failed otherwise than the reference
    PointKind kind = PointKind::Failed;
    std::vector<double> seconds; // of the solver, of the timed runs in rising order [s]
    double work = 0.0;           // right-hand sides, or films solved

    double fastest() const { return seconds.empty() ? 0.0 : seconds.front(); }
    double median() const { return medianOf(seconds); }
};

/// "rk4 (10 ns)".
std::string nameOf(const PrecisionTask& task, const PrecisionPoint& point);

struct PrecisionRuns {
    ProvenReference reference;
    std::vector<TrajectoryError> uncertainty; // what the reference does not know, as PrecisionPoint::errors
    std::vector<PrecisionPoint> points;       // method by method
    double secondsPerCost = 0.0;              // wall time of a run of unit cost (expected_cost.h) [s]
    bool late = false;                        // the budget was spent before
    bool referencesLate =
        false; // not all of the runs that may prove the reference, or its end, ended in their share of the budget
};

/// Tells the time that is left [s], as far as it can be expected, and what it does; false stops. `changed`: there is
/// more to show than at the last call.
using RunsCallback = std::function<bool(double left, const std::string& doing, bool changed)>;

/// `runs` is filled as it goes. Returns false where the callback stopped it.
bool performRuns(const PrecisionTask& task, int jobs, PrecisionRuns& runs, const RunsCallback& callback);

struct ErrorUnit {
    std::string si, displayed;
};
ErrorUnit unitOf(const PrecisionTask& task, ErrorMeasure measure);

/// The error that the chart shows; none of a run that failed or was not made.
std::optional<double> errorOf(const PrecisionTask& task, const PrecisionPoint& point);

/// The error that a run is worth: no less than the reference's uncertainty, and no less than those of finer settings of
/// its method, which show that a small error was luck.
std::optional<double> worthOf(const PrecisionTask& task, const PrecisionRuns& runs, const PrecisionPoint& point);
/// What the reference itself does not know, in the measure of the chart.
double uncertaintyOf(const PrecisionTask& task, const PrecisionRuns& runs);

/// Points than which no other costs as little and is worth as much, from the most accurate one to the cheapest; of
/// those that cost something.
std::vector<const PrecisionPoint*> paretoFront(const PrecisionTask& task, const PrecisionRuns& runs,
                                               const std::function<double(const PrecisionPoint&)>& cost);

} // namespace touchdown
