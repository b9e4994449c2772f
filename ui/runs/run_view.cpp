// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_view.h"

#include <QVBoxLayout>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "ui/disk/disk_surface_view.h"
#include "ui/plot/plot_group.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
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
    for (QWidget* page : {static_cast<QWidget*>(splitter_), static_cast<QWidget*>(side_), static_cast<QWidget*>(maps_),
                          static_cast<QWidget*>(disk_)})
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
        if (which == 0) side_->showTime(plots_->group()->cursor(0));
    });
    setCase({});
}

void RunView::setCase(const Case& c)
{
    model_ = c.model;
    if (c.run.duration != openedDuration_) plots_->group()->setFirstRange(std::nullopt);
    // Finding the contact patches of a film in recordedFields() is too slow for each key press.
    const bool maps = c.model == ModelKind::Film ? c.run.fieldSnapshots > 0 : !recordedFields(c).empty();
    const bool disk = findParameter("disk.surface.kind")->used(c);
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
