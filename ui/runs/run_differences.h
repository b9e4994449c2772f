// SPDX-License-Identifier: GPL-3.0-or-later
//
// Differences of runs from the baseline: those that are asked for, made on another thread. They stand in the record of
// their run (RunRecord::differences), so that they count as its memory and move to the disk with it.
#pragma once

#include <map>
#include <set>
#include <stop_token>
#include <string>
#include <utility>

#include <QObject>
#include <QString>
#include <QTimer>

#include "ui/calculation/task_queue.h"
#include "ui/plot/min_max_pyramid.h"

namespace touchdown {

class RunsModel;
struct RunRecord;

class RunDifferences : public QObject {
    Q_OBJECT

public:
    using Key = std::pair<int, std::string>; // number of the run, quantity

    /// `runs` must outlive it.
    RunDifferences(RunsModel& runs, QObject* parent);
    ~RunDifferences() override;

    /// nullptr where there is none, or while it is being made, which this call begins. It stays until keepOnly() or
    /// clear(), or until its run is removed.
    const MinMaxPyramid* of(const RunRecord& run, const std::string& quantity);
    bool isBegun(int run, const std::string& quantity) const { return begun_.contains({run, quantity}); }
    /// Why there is none though it was begun: a sentence; "" else.
    QString problem(int run, const std::string& quantity) const;
    /// Gives the others back; no curve may point to them any more.
    void keepOnly(const std::set<Key>& wanted);
    /// The baseline is another one.
    void clear() { keepOnly({}); }

signals:
    /// There are more.
    void made();

private:
    void begin(const RunRecord& run, const std::string& quantity);

    RunsModel& runs_;
    std::map<Key, std::stop_source> begun_;
    std::map<Key, QString> problems_;
    QTimer soon_; // so that many small ones are shown together
    TaskQueue queue_{this};
};

/// `run` minus `baseline` at the samples of `run`, where both are known; those so far when `stop` was requested.
MinMaxPyramid difference(const MinMaxPyramid& run, const MinMaxPyramid& baseline, const std::stop_token& stop = {});

} // namespace touchdown
