// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plots of the runs on one time axis, and the decision which quantities go in which plot.
//
// A plot with one quantity tells runs apart by colour and dash; a plot with several tells quantities apart by colour and
// runs by dash. With a baseline, every other run is shown as its difference from it.
#pragma once

#include "ui/plot_group.h"
#include "ui/runs_model.h"

#include <QWidget>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace touchdown {

class LivePlots : public QWidget {
    Q_OBJECT

public:
    /// `runs` must outlive the plots.
    explicit LivePlots(RunsModel& runs, QWidget* parent = nullptr);

    PlotGroup* group() const { return group_; }

    struct Entry {
        QString name;  // "spacing": of files and settings
        QString title; // "Minimum spacing"
        PlotWidget* plot;
        bool wanted = true; // by the user; shown if a run has its quantities too
    };
    const std::vector<Entry>& plots() const { return entries_; }
    PlotWidget* plot(const QString& name) const;
    void setWanted(const QString& name, bool wanted);

    /// Samples of this run have come.
    void dataArrived(int number);
    /// The run has ended: its last events, and its difference to the baseline.
    void runFinished(int number);

signals:
    /// Curves came or went.
    void curvesChanged();

private:
    struct Spec;
    static const std::vector<Spec>& specs();

    void addRun(int number);
    void removeRun(int number);
    void rebuild();
    void addCurves(const RunRecord& run);
    void noteHiddenCurves();
    const MinMaxPyramid* dataFor(const RunRecord& run, const std::string& quantity);
    void updateMarks();
    void updateVisibility();
    const RunRecord* newestShown() const;

    RunsModel& runs_;
    PlotGroup* group_;
    std::vector<Entry> entries_;
    std::map<QString, std::unique_ptr<MinMaxPyramid>> differences_; // by id of the curve
    std::set<int> drawn_;                // numbers of the runs that were shown when curves were last made
    std::map<std::string, bool> wanted_; // by quantity: what the user chose in the menus of the plots
    std::size_t marksShown_ = 0;
};

} // namespace touchdown
