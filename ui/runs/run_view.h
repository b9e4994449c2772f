// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of runs over time: plots and spectrum; and where the case has them, the slider from the side, the maps of
// film and contact, and the surface of the disk.
#pragma once

#include <array>
#include <optional>

#include <QAction>
#include <QByteArray>
#include <QLabel>
#include <QMenu>
#include <QPointer>
#include <QResizeEvent>
#include <QSplitter>
#include <QStackedWidget>
#include <QStringList>
#include <QTabBar>

#include "core/case/case.h"
#include "ui/plot/min_max_pyramid.h"

namespace touchdown {

class DiskSurfaceView;
class LivePlots;
class LiveSpectrum;
class QuantityList;
class RunMaps;
class RunsModel;
class ReplayBar;
class SideView;

/// What a demonstration shows of the plots, until it ends; what the user chose comes back then.
struct PlotStage {
    QStringList plots; // names, as LivePlots has them
    bool side = false; // the side view above them
    bool spectrum = false;
    std::optional<PlotRange> time;    // of the time axis [s]; nothing: as without a stage
    std::optional<PlotRange> spacing; // of the minimum spacing [m]; nothing: as the data
    bool operator==(const PlotStage&) const = default;
};

class RunView : public QWidget {
    Q_OBJECT

public:
    enum class Page { Plots, Side, Maps, Disk };
    Q_ENUM(Page)

    /// `runs` must outlive the widget.
    explicit RunView(RunsModel& runs, QWidget* parent = nullptr);

    /// The case as it is edited decides which pages there are.
    void setCase(const Case& c);
    void setPage(Page page) { tabs_->setCurrentIndex(static_cast<int>(page)); }
    Page page() const { return static_cast<Page>(tabs_->currentIndex()); }
    void fit();
    /// A case was opened, with its name among the sample cases or none. The plots of the default case begin with the
    /// part of the run in which it bounces.
    void opened(const QString& sample, const Case& c);
    void setStage(const std::optional<PlotStage>& stage);
    const std::optional<PlotStage>& stage() const { return stage_; }

    LivePlots* plots() const { return plots_; }
    LiveSpectrum* spectrum() const { return spectrum_; }
    SideView* side() const { return side_; }
    /// The same above the plots, in which a run and its numbers are seen together.
    SideView* sideAbove() const { return sideAbove_; }
    std::array<SideView*, 2> sides() const { return {side_, sideAbove_}; }
    ReplayBar* replay() const { return replay_; }
    RunMaps* maps() const { return maps_; }
    DiskSurfaceView* disk() const { return disk_; }
    QSplitter* splitter() const { return splitter_; }
    QTabBar* tabs() const { return tabs_; }
    /// Whether the spectrum is wanted; a slow approach has none worth seeing.
    QAction* sideWanted() const { return sideWanted_; }
    /// Whether the list of quantities stands beside the plots.
    QAction* quantitiesWanted() const { return quantitiesWanted_; }
    QuantityList* quantities() const { return quantities_; }
    /// Offers the plots, new ones, the spectrum and the list of quantities.
    void fillPlotsMenu(QMenu& menu);

signals:
    /// The user or the program went to another page.
    void pageChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void showParts();
    bool roomForSide() const;
    int sharesOfPlots() const;
    void shareHeight();
    void showTime();
    void forgetTime();
    void lookAtEvents();
    /// What to do, where there is nothing to see.
    void showHint();
    std::optional<PlotRange> replayed() const;

    RunsModel& runs_;
    ModelKind model_ = ModelKind::Springs;
    double duration_ = 0.0;              // of the case [s]
    std::optional<PlotRange> firstTime_; // shown of runs of this duration, where it is a part [s]
    bool eventsSeen_ = false;            // of a run of this duration: they chose firstTime_, or the whole run
    LivePlots* plots_;
    LiveSpectrum* spectrum_;
    std::optional<PlotStage> stage_;
    QByteArray beforeStage_; // of the splitter
    SideView* side_;
    SideView* sideAbove_;
    ReplayBar* replay_;
    ReplayBar* replayAbove_;
    QWidget* above_; // the side view and its replay above the plots
    RunMaps* maps_;
    DiskSurfaceView* disk_;
    QSplitter* splitter_;
    QTabBar* tabs_;
    QStackedWidget* pages_;
    QAction *spectrumWanted_, *sideWanted_, *quantitiesWanted_;
    QuantityList* quantities_;
    QLabel* hint_;             // over the plots while they are empty
    QPointer<QMenu> newPlots_; // within the menu of the plots
};

} // namespace touchdown
