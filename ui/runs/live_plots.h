// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plots of the runs: those on one time axis under each other, and beside them phase portraits, a quantity against
// another one. Which quantities stand in which plot: ui/runs/plot_spec.h. The user adds curves and plots, in menus or
// by dragging a quantity from a list.
//
// One run speaks, the others whisper: the newest run, or the one under the pointer in a legend or in the list, is wide
// and above the others, which are thin and pale. The automatic ranges are those of the newest run. A plot with one
// quantity distinguishes runs by colour, a plot with several distinguishes quantities by colour. With a baseline, every
// other run is shown as its difference from it, which is made on another thread (ui/runs/run_differences.h).
#pragma once

#include <QAction>
#include <QHBoxLayout>
#include <QJsonObject>
#include <QMenu>
#include <QMimeData>
#include <QStringList>
#include <QVBoxLayout>
#include <QWidget>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "ui/plot/plot_curve.h"
#include "ui/runs/plot_spec.h"
#include "ui/runs/run_differences.h"

namespace touchdown {

class DropHint;
class LiveSpectrogram;
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
    const PlotSpec& spec(const QString& name) const;
    LiveSpectrogram* spectrogram() const { return spectrogram_; }
    /// The case that is edited. Before its first run, the plots of the quantities that it will record are shown.
    void setCase(const Case& c);
    /// Shows these plots alone, whatever the user chose; nothing: as the user chose.
    void setStage(const std::optional<QStringList>& names);

    /// A word at a place of the curves of a run: where to look.
    struct Word {
        int run = -1; // number of it
        QString plot;
        double at = 0.0; // [s]
        QString text;
        bool operator==(const Word&) const = default;
    };
    void setWords(std::vector<Word> words);

    /// Samples of this run have arrived.
    void dataArrived(int number);
    /// The run has ended: its last events, and its difference to the baseline.
    void runFinished(int number);

    /// Those of the shown runs and of the case, each name once.
    std::vector<Quantity> quantities() const;
    /// A plot of the user's own, with this quantity over time; its name.
    QString addPlot(const Quantity& up);
    void removePlot(const QString& own);
    /// Another curve in a plot. A sentence that says why not; empty: it is there.
    QString addCurve(const QString& plot, const Quantity& quantity);
    /// One that the user added.
    void removeCurve(const QString& plot, const std::string& quantity);
    /// What stands across a plot whose axes can be chosen, and what stands up; none: the time, what there is.
    void setAxes(const QString& plot, const std::optional<Quantity>& across, const std::optional<Quantity>& up);

    /// For the settings: the user's own plots and curves, which plots are shown, what stands on their axes.
    QJsonObject arrangement() const;
    /// At the start, before plots were added.
    void restore(const QJsonObject& arrangement);

signals:
    /// Differences to the baseline have been made: they take memory.
    void differencesMade();
    /// Curves were added or removed.
    void curvesChanged();
    /// There are more or fewer plots().
    void plotsChanged();
    /// quantities() may have changed.
    void quantitiesChanged();
    /// Why a quantity that was dropped cannot stand where it was.
    void refused(const QString& reason);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    struct Drop {
        std::optional<Quantity> quantity; // that is dragged
        QString plot;                     // in which it would stand; empty: a plot of its own
        QRect target;
        QString text;
        QString refusal;
    };
    Drop dropAt(const QPoint& at, const QMimeData& dragged) const;

    void makePlot(std::size_t spec);
    void placePlot(std::size_t spec);
    void updateTitle(std::size_t spec);
    void labelPlots();
    void labelAxes(std::size_t spec);
    void addMenus(const QString& plot);
    void addSpectrogramMenus();
    std::size_t indexOf(const QString& name) const;

    void removeRun(int number);
    void rebuild();
    std::vector<PlotCurve> curvesOf(std::size_t spec, std::set<RunDifferences::Key>& used);
    PlotCurve curveOf(const RunRecord& run, std::size_t spec, std::size_t curve) const;
    void raise(const QString& curve);
    void noteHiddenCurves();
    QString missingDifference(std::size_t spec) const;
    bool isShown(std::size_t spec) const;
    void updateMarks();
    std::vector<PointMark> wordsOf(std::size_t spec) const;
    std::vector<PointMark> eventPoints(const RunRecord& run) const;
    void updateWanted();
    void updateVisibility();

    RunsModel& runs_;
    PlotGroup* group_;
    QHBoxLayout* columns_;
    QVBoxLayout *overTime_, *portraits_; // side by side
    std::vector<PlotSpec> specs_;
    ModelKind model_ = ModelKind::Springs;                 // of the case
    bool flat_ = true;                                     // its disk is
    bool rollIsHeld_ = true;                               // in it
    std::vector<Quantity> ready_;                          // that the case would record
    std::map<std::pair<ModelKind, QString>, bool> chosen_; // whether a plot is wanted, as the user said
    std::optional<QStringList> stage_;                     // the plots shown instead
    std::vector<Entry> entries_;                           // one for each of `specs_`
    RunDifferences* differences_;
    int speaker_ = -1;                   // number of the run that was wide when curves were last made
    int leader_ = -1;                    // of the newest one shown
    std::set<int> drawn_;                // numbers of the runs that were shown when curves were last made
    std::map<std::string, bool> wanted_; // by plot and quantity: what the user chose in the menus of the plots
    std::size_t marksShown_ = 0;
    std::vector<Word> words_;
    DropHint* hint_;
    LiveSpectrogram* spectrogram_ = nullptr;
};

} // namespace touchdown
