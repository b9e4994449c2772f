// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the case again while the reader moves one of its values.
//
// Springs run at each movement, beside the window, in milliseconds: one run of the list is made anew again and again,
// with the newest value whenever the last run is there, as far as the plots show it. When the reader lets go, it is a
// whole run. So does a linear film, about a static state that is known; when the reader lets go, about its own. A case
// that takes longer runs when the reader lets go; a film first on a coarse grid, then on its own.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>

#include "core/case/case.h"
#include "core/studies/lesson/lesson.h"
#include "ui/calculation/task_queue.h"

namespace touchdown {

class RunView;
class Workbench;
struct RunRecord;
struct Summary;

/// A film's grid with half the intervals along and across, its elastic contact with cells of twice the side. Nothing is
/// coarser where that gives no case that can run.
Case coarser(const Case& c);

bool isLinearFilm(const Case& c);
/// Whether a run of it may follow the hand: of springs, and of a linear film.
bool followsHand(const Case& c);

/// Until when a run is wanted for what the view shows [s]: to the end of the time axis, where that is not the end of
/// the run and nothing else needs the rest.
double neededUntil(const RunView& view, const Case& c);

class LiveRuns : public QObject {
    Q_OBJECT

public:
    LiveRuns(Workbench& bench, QObject* parent);
    ~LiveRuns() override; // the list of runs may be gone

    /// The parameters get this value, as a case file has it.
    void move(const LiveValue& value, const std::string& text);
    /// The movement has ended.
    void settle();
    /// The values were changed without a movement, as by undo: a run of them.
    void runAnew();
    /// Nothing more is run or shown of it: another case is open, or the user stopped it.
    void leave();
    bool busy() const { return movement_ && movement_->busy; }
    /// Whether the run under way has to find a static state, which takes seconds.
    bool finds() const { return movement_ && movement_->finds; }

signals:
    /// A run beside the window has begun or ended, or is left.
    void busyChanged();
    /// A run of a movement is in the list.
    void shown(int number);

private:
    /// From the first change of a value until the reader lets go.
    struct Movement {
        int merge = 0;        // of its edits, which are one for undo
        int number = -1;      // of its run in the list
        Case value;           // the newest
        std::string text;     // of the case; empty until the reader lets go
        bool settled = false; // the reader let go
        bool anew = false;    // nobody moved a slider
        bool part = false;    // the last run ends where the plots end, or is about the state of a similar case
        bool busy = false;    // a run is under way beside the window
        bool finds = false;   // that run begins with a static state that is to be found
        bool preview = false; // the run in the list is about the state of a similar case
        bool slow = false;    // a run takes too long for that
        std::atomic<bool> left = false;
    };
    struct TwoGrids {
        Case own;
        std::string text;           // of it
        int coarse = -1, fine = -1; // numbers of the runs
    };

    std::shared_ptr<Movement> begun();
    void runOnce(const std::shared_ptr<Movement>& movement);
    void show(const std::shared_ptr<Movement>& movement, std::unique_ptr<RunRecord> record);
    void finish(Movement& movement);
    void forgetPart(Movement& movement);
    void stop(Movement& movement);
    void runFilm();
    void onEnded(int number, const Summary& summary);

    Workbench& bench_;
    int movements_ = 0; // so far
    std::shared_ptr<Movement> movement_;
    std::vector<std::weak_ptr<Movement>> all_; // whose runs may still be under way
    std::optional<TwoGrids> grids_;
    TaskQueue queue_; // last: its tasks use what stands above
};

} // namespace touchdown
