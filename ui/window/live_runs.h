// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the case again while the reader moves one of its values.
//
// Springs run at each movement, beside the window, in milliseconds: one run of the list is made anew again and again,
// with the newest value whenever the last run is there. When the reader lets go, it becomes a run like any other. A
// film runs when the reader lets go, first on a coarse grid, then on its own.
#pragma once

#include <memory>

#include <QObject>

#include "core/studies/lesson/lesson.h"
#include "ui/calculation/task_queue.h"

namespace touchdown {

class MainWindow;
struct RunRecord;
struct Summary;

/// A film's grid with half the intervals along and across, its elastic contact with cells of twice the side. Nothing is
/// coarser where that gives no case that can run.
Case coarser(const Case& c);

class LiveRuns : public QObject {
    Q_OBJECT

public:
    explicit LiveRuns(MainWindow& window);

    /// A parameter gets this number [its unit].
    void move(const LiveValue& value, double number);
    /// The movement has ended.
    void settle();
    bool busy() const { return busy_; }

signals:
    /// A run of a movement is in the list.
    void shown(int number);

private:
    void runOnce();
    void show(std::unique_ptr<RunRecord> record);
    void runFilm();
    void onEnded(int number, const Summary& summary);

    MainWindow& window_;
    TaskQueue queue_;
    int movement_ = 0;    // how many there were
    bool moving_ = false; // until the reader lets go
    int number_ = -1;     // of the run that this movement shows
    bool busy_ = false;   // a run is under way beside the window
    bool again_ = false;  // the value has changed since
    int coarse_ = -1;     // number of the run on a coarse grid, until the finer one has ended
    int fine_ = -1;
};

} // namespace touchdown
