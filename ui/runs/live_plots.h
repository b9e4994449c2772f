// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plots of the runs on one time axis, a plot of the forces against the separation, and the decision which
// quantities go in which plot.
//
// One run speaks, the others whisper: the newest run, or the one under the pointer in a legend or in the list, is wide
// and above the others, which are thin and pale. The automatic ranges are those of the newest run. A plot with one
// quantity distinguishes runs by colour, a plot with several distinguishes quantities by colour. With a baseline, every
// other run is shown as its difference from it.
#pragma once

#include <QAction>
#include <QStringList>
#include <QVBoxLayout>
#include <QWidget>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "ui/plot/plot_curve.h"

namespace touchdown {

class PlotGroup;
class PlotWidget;
class RunsModel;
struct RunRecord;

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
        QAction* wanted; // by the user, checkable; shown if a run has its quantities too
    };
    const std::vector<Entry>& plots() const { return entries_; }
    const Entry& entry(const QString& name) const;
    PlotWidget* plot(const QString& name) const { return entry(name).plot; }
    /// The case that is edited. Before its first run, the plots of the quantities that it will record are shown.
    void setCase(const Case& c);
    /// Shows these plots alone, whatever the user chose; nothing: as the user chose.
    void setStage(const std::optional<QStringList>& names);

    /// Samples of this run have arrived.
    void dataArrived(int number);
    /// The run has ended: its last events, and its difference to the baseline.
    void runFinished(int number);

signals:
    /// Curves were added or removed.
    void curvesChanged();

private:
    struct Spec;
    static const std::vector<Spec>& specs();

    void removeRun(int number);
    void rebuild();
    std::vector<PlotCurve> curvesOf(std::size_t spec);
    PlotCurve curveOf(const RunRecord& run, std::size_t spec, std::size_t curve) const;
    void raise(const QString& curve);
    void noteHiddenCurves();
    const MinMaxPyramid* dataFor(const RunRecord& run, const std::string& quantity);
    void updateMarks();
    std::vector<PointMark> eventPoints(const RunRecord& run) const;
    void updateVisibility();

    RunsModel& runs_;
    PlotGroup* group_;
    QVBoxLayout* layout_;
    ModelKind model_ = ModelKind::Springs;                 // of the case
    std::vector<std::string> ready_;                       // quantities that the case would record
    std::map<std::pair<ModelKind, QString>, bool> chosen_; // whether a plot is wanted, as the user said
    std::optional<QStringList> stage_;
    std::vector<Entry> entries_;
    std::map<QString, std::unique_ptr<MinMaxPyramid>> differences_; // by id of the curve
    int speaker_ = -1;                   // number of the run that was wide when curves were last made
    int leader_ = -1;                    // of the newest one shown
    std::set<int> drawn_;                // numbers of the runs that were shown when curves were last made
    std::map<std::string, bool> wanted_; // by plot and quantity: what the user chose in the menus of the plots
    std::size_t marksShown_ = 0;
};

} // namespace touchdown
