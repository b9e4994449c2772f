// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_view.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QScrollArea>
#include <QVBoxLayout>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "ui/disk/disk_surface_view.h"
#include "ui/plot/plot_group.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/quantity_list.h"
#include "ui/runs/replay_bar.h"
#include "ui/runs/run_maps.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/runs/side_view.h"
#include "ui/style/foreign_text.h"

namespace touchdown {

namespace {

constexpr int linesOfPlot = 7, linesOfSideView = 10; // that can be read, in lines of text
constexpr double earlyEvents = 0.04;                 // of a run: behind them little is to be seen
constexpr double behindEvents = 1.5;                 // shown, of the time of the last one
constexpr double firstPart = 0.3e-3;                 // of the default case [s]: it is at rest after a sixth of its 2 ms

QWidget* withReplay(QWidget* view, QWidget* replay)
{
    auto* page = new QWidget(view->parentWidget());
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(view, 1);
    layout->addWidget(replay);
    return page;
}

} // namespace

RunView::RunView(RunsModel& runs, QWidget* parent)
    : QWidget(parent),
      runs_(runs),
      plots_(new LivePlots(runs, this)),
      spectrum_(new LiveSpectrum(runs, this)),
      side_(new SideView(runs, this)),
      sideAbove_(new SideView(runs, this)),
      replay_(new ReplayBar([this] { return replayed(); }, this)),
      replayAbove_(new ReplayBar([this] { return replayed(); }, this)),
      above_(withReplay(sideAbove_, replayAbove_)),
      maps_(new RunMaps(runs, this)),
      disk_(new DiskSurfaceView(this)),
      splitter_(new QSplitter(Qt::Vertical, this)),
      tabs_(new QTabBar(this)),
      pages_(new QStackedWidget(this)),
      spectrumWanted_(new QAction(tr("Power spectrum"), this)),
      sideWanted_(new QAction(tr("Side view above the plots"), this)),
      quantitiesWanted_(new QAction(tr("&List of quantities, to drag into plots"), this)),
      quantities_(new QuantityList(this)),
      hint_(new QLabel(plots_))
{
    hint_->setAlignment(Qt::AlignCenter);
    hint_->setAttribute(Qt::WA_TransparentForMouseEvents);
    hint_->setWordWrap(true);
    plots_->installEventFilter(this);
    for (const auto changed : {&RunsModel::rowsInserted, &RunsModel::rowsRemoved})
        connect(&runs_, changed, this, &RunView::showHint);
    connect(&runs_, &RunsModel::dataChanged, this, [this] { // a run has ended: the replay passes through all of it
        for (ReplayBar* replay : {replay_, replayAbove_}) replay->showTime(plots_->group()->cursor(0));
        lookAtEvents();
    });
    auto* plotsAndList = new QWidget(this);
    auto* plotsLayout = new QHBoxLayout(plotsAndList);
    plotsLayout->setContentsMargins(0, 0, 0, 0);
    plotsLayout->setSpacing(0);
    auto* scroll = new QScrollArea(plotsAndList); // where the plots have less room than they need to be read
    scroll->setWidget(plots_);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    plotsLayout->addWidget(scroll, 1);
    plotsLayout->addWidget(quantities_);
    quantities_->hide();
    splitter_->addWidget(above_);
    splitter_->addWidget(plotsAndList);
    splitter_->addWidget(spectrum_);
    splitter_->setStretchFactor(0, 1);
    splitter_->setStretchFactor(1, 2);
    splitter_->setStretchFactor(2, 1);
    splitter_->setSizes({400, 560, 280});
    splitter_->setChildrenCollapsible(true);
    splitter_->setCollapsible(1, false);
    for (QWidget* page : {static_cast<QWidget*>(splitter_), withReplay(side_, replay_), static_cast<QWidget*>(maps_),
                          static_cast<QWidget*>(disk_)})
        pages_->addWidget(page);

    for (const QString& name : {tr("Plots"), tr("Side view"), tr("Maps"), tr("Disk surface")}) tabs_->addTab(name);
    tabs_->setAccessibleName(tr("Views of the runs"));
    tabs_->setExpanding(false);
    tabs_->setFocusPolicy(Qt::StrongFocus);
    tabs_->setDocumentMode(true);
    spectrumWanted_->setCheckable(true);
    spectrumWanted_->setChecked(true);
    sideWanted_->setCheckable(true);
    quantitiesWanted_->setCheckable(true);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(tabs_);
    layout->addWidget(pages_, 1);
    connect(tabs_, &QTabBar::currentChanged, pages_, &QStackedWidget::setCurrentIndex);
    connect(tabs_, &QTabBar::currentChanged, this, &RunView::pageChanged);
    for (const QAction* wanted : {spectrumWanted_, sideWanted_})
        connect(wanted, &QAction::toggled, this, &RunView::showParts);
    connect(quantitiesWanted_, &QAction::toggled, quantities_, &QWidget::setVisible);
    connect(plots_, &LivePlots::quantitiesChanged, this, [this] { quantities_->setQuantities(plots_->quantities()); });
    connect(quantities_, &QuantityList::plotWanted, plots_, &LivePlots::addPlot);
    // The cursor of the plots follows the time of the maps.
    connect(maps_, &RunMaps::timeChosen, plots_->group(), [this](double time) { plots_->group()->setCursor(0, time); });
    connect(plots_->group(), &PlotGroup::cursorMoved, side_, [this](int which) {
        if (which != 0) return;
        for (SideView* side : sides()) side->showTime(plots_->group()->cursor(0));
        for (ReplayBar* replay : {replay_, replayAbove_}) replay->showTime(plots_->group()->cursor(0));
    });
    // What is shown is what is replayed.
    connect(plots_->group(), &PlotGroup::historyChanged, side_, [this] {
        for (ReplayBar* replay : {replay_, replayAbove_}) replay->showTime(plots_->group()->cursor(0));
    });
    for (const ReplayBar* replay : {replay_, replayAbove_})
        connect(replay, &ReplayBar::timeChosen, this, [this](double time) { plots_->group()->setCursor(0, time); });
    setCase({});
}

void RunView::setCase(const Case& c)
{
    model_ = c.model;
    if (c.run.duration != duration_) {
        duration_ = c.run.duration;
        forgetTime();
    }
    const bool maps = recordsFields(c);
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
    hint_->setText(model_ == ModelKind::Film ? tr("F5 runs this case in time. F9 finds its static state.")
                                             : tr("F5 runs this case in time."));
    showParts();
}

void RunView::showHint()
{
    const std::vector<PlotWidget*>& plots = plots_->group()->plots();
    const auto first = std::ranges::find_if(plots, [](const PlotWidget* plot) { return !plot->isHidden(); });
    hint_->setVisible(first != plots.end() && runs_.count() == 0);
    if (first != plots.end()) hint_->setGeometry({(*first)->mapTo(plots_, QPoint(0, 0)), (*first)->size()});
    hint_->raise();
}

bool RunView::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)
        QMetaObject::invokeMethod(this, &RunView::showHint, Qt::QueuedConnection); // when the plots have their places
    return QWidget::eventFilter(watched, event);
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
    duration_ = c.run.duration;
    forgetTime();
    if (sample == QLatin1String(defaultCaseName)) firstTime_ = PlotRange{0.0, firstPart};
    runs_.setOpened(c);
    showTime();
}

void RunView::forgetTime()
{
    firstTime_.reset();
    eventsSeen_ = false;
    showTime();
}

/// The first run that comes to rest early decides what is shown of all runs of this duration.
void RunView::lookAtEvents()
{
    const RunRecord* run = runs_.newestShown();
    if (!run || !run->finished() || run->events.empty() || firstTime_ || stage_ || eventsSeen_) return;
    if (plots_->group()->follow() == PlotGroup::Follow::Frozen) return;
    eventsSeen_ = true;
    const double last = run->events.back().time;
    if (!(last > 0.0) || last > earlyEvents * run->value.run.duration) return;
    const double unit = std::pow(10.0, std::floor(std::log10(last)));
    firstTime_ = PlotRange{0.0, std::ceil(behindEvents * last / unit) * unit};
    showTime();
}

void RunView::showTime()
{
    std::optional<PlotRange> range = firstTime_;
    if (stage_ && stage_->time) range = stage_->time;
    plots_->group()->setFirstRange(range);
}

void RunView::setStage(const std::optional<PlotStage>& stage)
{
    if (stage == stage_) return;
    if (!stage_) beforeStage_ = splitter_->saveState();
    stage_ = stage;
    plots_->setStage(stage ? std::optional(stage->plots) : std::nullopt);
    spectrum_->view()->plot()->setAllDecide(stage.has_value());
    showParts();
    PlotGroup* group = plots_->group();
    for (PlotWidget* plot : group->plots()) plot->setView({plot->view().x, std::nullopt});
    if (stage && stage->spacing) {
        PlotWidget* spacing = plots_->plot(QStringLiteral("spacing"));
        spacing->setView({spacing->view().x, stage->spacing});
    }
    group->setFollow(PlotGroup::Follow::WholeRun);
    group->followNewest();
    showTime();
    group->forgetHistory();
    if (stage_)
        shareHeight();
    else
        splitter_->restoreState(beforeStage_);
}

/// The parts of a stage: each plot has two shares, the side view and the spectrum three.
void RunView::shareHeight()
{
    showParts();
    const int share = std::max(splitter_->height() / (sharesOfPlots() + 6), 1);
    splitter_->setSizes({3 * share, sharesOfPlots() * share, 3 * share});
}

int RunView::sharesOfPlots() const { return std::max(2 * static_cast<int>(stage_->plots.size()), 3); }

void RunView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (stage_) shareHeight();
}

void RunView::showParts()
{
    const bool slider = model_ != ModelKind::Contact;
    spectrum_->setVisible(slider && (stage_ ? stage_->spectrum : spectrumWanted_->isChecked()));
    above_->setVisible(slider && (stage_ ? stage_->side && roomForSide() : sideWanted_->isChecked()));
}

/// A low place is for the plots of a stage; the side view has a page of its own.
bool RunView::roomForSide() const
{
    const int plots = static_cast<int>(stage_->plots.size() + (stage_->spectrum ? 1 : 0));
    const int height = splitter_->height(), line = fontMetrics().height();
    const int own = 3 * height / (3 + sharesOfPlots() + (stage_->spectrum ? 3 : 0));
    return height >= line * (linesOfPlot * plots + linesOfSideView) && own >= line * linesOfSideView;
}

void RunView::fillPlotsMenu(QMenu& menu)
{
    menu.clear();
    for (const LivePlots::Entry& entry : plots_->plots()) menu.addAction(entry.wanted);
    menu.addAction(spectrumWanted_);
    menu.addAction(sideWanted_);
    menu.addSeparator();
    delete newPlots_; // clear() leaves the menus within
    auto* more = menu.addMenu(tr("&New plot of"));
    newPlots_ = more;
    connect(more, &QMenu::aboutToShow, this, [this, more] {
        more->clear();
        for (const Quantity& quantity : plots_->quantities())
            more->addAction(onButton(QString::fromStdString(quantity.longName)), this,
                            [this, quantity] { plots_->addPlot(quantity); });
    });
    menu.addAction(quantitiesWanted_);
}

void RunView::fit()
{
    plots_->group()->fit();
    spectrum_->view()->group()->fit();
    maps_->fit();
    disk_->fit();
}

} // namespace touchdown
