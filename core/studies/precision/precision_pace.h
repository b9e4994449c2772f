// SPDX-License-Identifier: GPL-3.0-or-later
//
// The time that a study of accuracy against speed still takes: the expected cost of each run that is to be made
// (expected_cost.h), at the pace of the runs so far. The references come first, several at a time; then each point
// once, and the repeats of the short ones, one at a time.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/work/work_done.h"

namespace touchdown {

struct Case;
struct PrecisionTask;

class PrecisionPace {
public:
    /// `points`: the cases, point by point.
    PrecisionPace(const PrecisionTask& task, int jobs, const std::vector<const Case*>& points);

    /// For the thread of a reference run.
    ShareTeller tellerOfReference(std::size_t i) { return references_.teller(i); }
    void endReferences() { atReferences_ = false; }
    void beginPoint(std::size_t i);
    void endPoint();
    /// No point is run for the first time any more.
    void beginRepeats();

    /// The time to the end of references and points [s]; the budget may end them earlier.
    double left();
    /// Wall time of a run of unit cost, in a row of runs [s].
    double secondsPerCost() const { return pace_; }

private:
    struct Point {
        double cost = 0.0;
        std::optional<double> seconds; // of its last run
        int repeats = 0;               // still to be made
    };
    double expected(const Point& point) const { return point.seconds.value_or(point.cost * pace_); }

    double timeLimit_;     // of a run that is repeated [s]
    double begin_;         // wall clock [s]
    double referenceCost_; // of one thread
    double pace_;          // [s]
    bool atReferences_ = true;
    WorkDone references_;
    std::vector<Point> points_;
    Point* now_ = nullptr;  // whose run is under way
    double nowBegin_ = 0.0; // wall clock [s]
};

} // namespace touchdown
