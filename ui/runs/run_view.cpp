// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_view.h"

#include <algorithm>

#include <QVBoxLayout>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "ui/disk/disk_surface_view.h"
#include "ui/plot/plot_group.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/replay_bar.h"
#include "ui/runs/run_maps.h"
#include "ui/runs/side_view.h"

namespace touchdown {

namespace {

constexpr double firstPart = 0.3e-3; // of the default case [s]: it is at rest after a sixth of its 2 ms

} // namespace

RunView::RunView(RunsModel& runs, QWidget* parent)
    : QWidget(parent),
      plots_(new LivePlots(runs, this)),
      spectrum_(new LiveSpectrum(runs, this)),
      side_(new SideView(runs, this)),
      replay_(new ReplayBar([this] { return replayed(); }, this)),
      maps_(new RunMaps(runs, this)),
      disk_(new DiskSurfaceView(this)),
      splitter_(new QSplitter(Qt::Vertical, this)),
      tabs_(new QTabBar(this)),
      pages_(new QStackedWidget(this)),
      spectrumWanted_(new QAction(tr("Power spectrum"), this))
{
    splitter_->addWidget(plots_);
    splitter_->addWidget(spectrum_);
    splitter_->setStretchFactor(0, 2);
    splitter_->setStretchFactor(1, 1);
    splitter_->setSizes({560, 280});
    splitter_->setChildrenCollapsible(true);
    splitter_->setCollapsible(0, false);
    auto* sidePage = new QWidget(this);
    auto* sideLayout = new QVBoxLayout(sidePage);
    sideLayout->setContentsMargins(0, 0, 0, 0);
    sideLayout->setSpacing(0);
    sideLayout->addWidget(side_, 1);
    sideLayout->addWidget(replay_);
    for (QWidget* page :
         {static_cast<QWidget*>(splitter_), sidePage, static_cast<QWidget*>(maps_), static_cast<QWidget*>(disk_)})
        pages_->addWidget(page);

    for (const QString& name : {tr("Plots"), tr("Side view"), tr("Maps"), tr("Disk surface")}) tabs_->addTab(name);
    tabs_->setAccessibleName(tr("Views of the runs"));
    tabs_->setExpanding(false);
    tabs_->setFocusPolicy(Qt::StrongFocus);
    tabs_->setDocumentMode(true);
    spectrumWanted_->setCheckable(true);
    spectrumWanted_->setChecked(true);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(tabs_);
    layout->addWidget(pages_, 1);
    connect(tabs_, &QTabBar::currentChanged, pages_, &QStackedWidget::setCurrentIndex);
    connect(spectrumWanted_, &QAction::toggled, this, &RunView::showSpectrum);
    // The cursor of the plots follows the time of the maps.
    connect(maps_, &RunMaps::timeChosen, plots_->group(), [this](double time) { plots_->group()->setCursor(0, time); });
    connect(plots_->group(), &PlotGroup::cursorMoved, side_, [this](int which) {
        if (which != 0) return;
        side_->showTime(plots_->group()->cursor(0));
        replay_->showTime(plots_->group()->cursor(0));
    });
    connect(replay_, &ReplayBar::timeChosen, this, [this](double time) { plots_->group()->setCursor(0, time); });
    setCase({});
}

void RunView::setCase(const Case& c)
{
    model_ = c.model;
    if (c.run.duration != openedDuration_) plots_->group()->setFirstRange(std::nullopt);
    // Finding the contact patches of a film in recordedFields() is too slow for each key press.
    const bool maps = c.model == ModelKind::Film ? c.run.fieldSnapshots > 0 : !recordedFields(c).empty();
    const bool flatUnderSprings = c.model == ModelKind::Springs && c.diskSurface.kind == DiskSurfaceKind::Flat;
    const bool disk = findParameter("disk.surface.kind")->used(c) && !flatUnderSprings;
    const bool side = c.model != ModelKind::Contact;
    tabs_->setTabVisible(static_cast<int>(Page::Side), side);
    tabs_->setTabVisible(static_cast<int>(Page::Maps), maps);
    tabs_->setTabVisible(static_cast<int>(Page::Disk), disk);
    tabs_->setVisible(side || maps || disk);
    if (!tabs_->isTabVisible(tabs_->currentIndex())) setPage(Page::Plots);
    plots_->setCase(c);
    disk_->setCase(c);
    showSpectrum();
}

/// The part of the shown run that the plots show.
std::optional<PlotRange> RunView::replayed() const
{
    const std::optional<PlotRange> run = side_->span();
    const PlotRange& shown = plots_->plot(QStringLiteral("spacing"))->xAxis().range();
    if (!run || shown.high <= run->low || shown.low >= run->high) return run;
    return PlotRange{std::max(run->low, shown.low), std::min(run->high, shown.high)};
}

void RunView::opened(const QString& sample, const Case& c)
{
    const bool first = sample == QLatin1String(defaultCaseName);
    openedDuration_ = first ? c.run.duration : 0.0;
    plots_->group()->setFirstRange(first ? std::optional(PlotRange{0.0, firstPart}) : std::nullopt);
}

void RunView::showSpectrum() { spectrum_->setVisible(spectrumWanted_->isChecked() && model_ != ModelKind::Contact); }

void RunView::fit()
{
    plots_->group()->fit();
    spectrum_->view()->group()->fit();
    maps_->fit();
    disk_->fit();
}

} // namespace touchdown
