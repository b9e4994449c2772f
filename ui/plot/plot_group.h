// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plots that belong together: one axis of time or frequency, one zoom history, one pair of cursors, and the menu of the
// right mouse button. The axis follows the run or is frozen. Over frequency cursors go to peaks, and values are those
// of the nearest sample: a spectrum has none between its bins.
//
// The group does not own its plots. A plot leaves the group when it is destroyed. The axes follow the curves that lead:
// the newest run. Zooming x by hand freezes the time axis; fitting shows everything, until a new run begins. A phase
// portrait shares cursors and history and shows the samples within the range of the time axis, but has an x axis of its
// own. The other shown plots leave equal room for labels of reference lines, so that their axes stay aligned.
#pragma once

#include "ui/plot/plot_widget.h"

#include <array>
#include <vector>

#include <QObject>

namespace touchdown {

/// A curve at the cursors, for tables. Numbers in SI.
struct CursorReading {
    const PlotWidget* plot = nullptr;
    QString curve;   // id
    QString name;    // "Energy: kinetic, FH 5 nm"; the title of the plot alone where the curve has no other name; of a
                     // spectrum the name of the run
    QString heading; // what several rows share: "Energy: kinetic" of runs, "Energy" of curves; empty: nothing
    QString entry;   // the rest: "FH 5 nm", or the name where there is no heading
    int run = 0;     // number of its run, where others stand beside it
    CurveStyle style;
    bool pale = false;
    std::optional<double> first;  // at cursor 1
    std::optional<double> second; // at cursor 2
};

class PlotGroup : public QObject {
    Q_OBJECT

public:
    enum class Follow { WholeRun, Frozen };
    Q_ENUM(Follow)

    enum class Across { Time, Frequency };

    explicit PlotGroup(QObject* parent = nullptr, Across across = Across::Time);
    Across across() const { return across_; }

    void add(PlotWidget* plot);
    void remove(PlotWidget* plot);
    const std::vector<PlotWidget*>& plots() const { return plots_; }

    /// The data behind the plots grew: all refresh soon, and the time axis follows. One call for each batch is enough.
    void dataChanged();

    void setFollow(Follow follow);
    Follow follow() const { return follow_; }
    void fit(); // all x and y show all data; a step of the history
    /// A new run begins: the automatic ranges are again those of the curves that lead.
    void followNewest();
    /// The range of the time axis, instead of the whole run, until the axis is zoomed or everything is shown.
    void setFirstRange(std::optional<PlotRange> range);
    /// The range of the time axis where the length of the run does not change it.
    std::optional<PlotRange> fixedRange() const;

    bool canGoBack() const { return position_ > 0; }
    bool canGoForward() const { return position_ + 1 < history_.size(); }
    void goBack();
    void goForward();
    void forgetHistory(); // as for a new run

    void setCursor(int which, std::optional<double> at); // time [s] or frequency [Hz]
    std::optional<double> cursor(int which) const { return cursors_[static_cast<std::size_t>(which)]; }
    bool hasCursors() const { return cursors_[0] || cursors_[1]; }
    /// Values of all visible curves of all plots that are not phase portraits. Those with one heading are neighbours,
    /// the newest run first.
    std::vector<CursorReading> readings() const;

signals:
    void followChanged(touchdown::PlotGroup::Follow follow);
    void historyChanged();
    /// Cursor 0 or 1 moved, came or went; ask cursor() and readings().
    void cursorMoved(int which);

private:
    struct State {
        Follow follow = Follow::WholeRun;
        bool everything = false;
        std::optional<PlotRange> first;
        std::optional<PlotRange> x;                                // when frozen
        std::vector<std::pair<const PlotWidget*, PlotView>> views; // x only of phase portraits
        bool operator==(const State&) const = default;
    };

    void onViewChanged(PlotWidget* plot, const PlotView& view, PlotWidget::Gesture gesture);
    void followData();
    void showX(const PlotRange& range);
    void shareLabelWidth();
    void changeFollow(Follow follow);
    void showEverything(bool everything);
    State state() const;
    void show(const State& state);
    void step(std::size_t position);
    void record(std::optional<PlotWidget::Gesture> gesture, const PlotWidget* plot);

    std::optional<double> valueAt(const PlotCurve& curve, int which) const;

    Across across_;
    std::vector<PlotWidget*> plots_;
    Follow follow_ = Follow::WholeRun;
    bool everything_ = false;
    std::optional<PlotRange> firstRange_;
    PlotRange xRange_;
    std::array<std::optional<double>, 2> cursors_;
    std::vector<State> history_;
    std::size_t position_ = 0;
    std::optional<PlotWidget::Gesture> lastGesture_;
    const PlotWidget* lastPlot_ = nullptr;
};

} // namespace touchdown
