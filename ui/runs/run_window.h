// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of the window that belongs to runs over time: their page, the panes with the runs and the values at the
// cursors, the progress, and the solver between them.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include <QObject>

#include "ui/runs/run_controller.h"
#include "ui/runs/run_memory.h"
#include "ui/runs/runs_model.h"

namespace touchdown {

class CursorTable;
class ProgressStrip;
class RunView;
class RecordPanel;

class RunWindow : public QObject {
    Q_OBJECT

public:
    explicit RunWindow(QWidget* parent);
    ~RunWindow() override;

    RunsModel& runs() { return runs_; }
    RunController& controller() { return controller_; }
    RunMemory& memory() { return memory_; }
    RunView* view() const { return view_; }
    RecordPanel* panel() const { return panel_; }
    CursorTable* values() const { return values_; }
    ProgressStrip* progress() const { return progress_; }
    /// nullptr: none is.
    RunRecord* runUnderWay() { return runs_.find(number_); }

    /// Where a run that starts finds a static state in hand, see RunOptions::rest; null: there is none.
    using RestOf = std::function<std::shared_ptr<const StaticSolution>(const Case&)>;
    void takeRestsFrom(RestOf restOf) { restOf_ = std::move(restOf); }
    /// An active run ends, with its signals, before the new one is in the list.
    void start(RunRequest request);
    /// A run that was performed elsewhere, and is in the list, is told of as one that has just ended: at once, or when
    /// the active one ends.
    void announce(int number);

signals:
    void started(int number);
    /// After the page shows the end.
    void ended(int number, const touchdown::Summary& summary);

private:
    void add(const RunRequest& request);
    void onDelivered(const RunDelivery& delivery);
    void onFinished(const Summary& summary);
    void conclude(const Summary& summary);

    RunsModel runs_;
    RunController controller_;
    RunMemory memory_{runs_};
    RunView* view_;
    RecordPanel* panel_;
    CursorTable* values_;
    ProgressStrip* progress_;
    RestOf restOf_;
    int number_ = -1;    // in the list, of the active run
    int announced_ = -1; // of a run that waits for its end
};

} // namespace touchdown
