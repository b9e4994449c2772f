// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/film_view.h"

#include <algorithm>
#include <utility>

#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady.h"
#include "ui/film/modes_page.h"
#include "ui/film/series_page.h"
#include "ui/film/surface_page.h"
#include "ui/maps/field_map.h"
#include "ui/maps/fields_view.h"
#include "ui/maps/map_kinds.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

/// The middle of the cell with the smallest gap: the point of minimum spacing itself lies on the border of a rail.
std::optional<SurfacePoint> nearestTheDisk(const SteadyResult& result)
{
    if (result.gap.empty()) return std::nullopt;
    const auto cell = static_cast<int>(std::ranges::min_element(result.gap) - result.gap.begin());
    return SurfacePoint{result.grid.centreX(cell % result.grid.nx()), result.grid.centreY(cell / result.grid.nx())};
}

} // namespace

FilmView::FilmView(QAction* solve, QWidget* parent)
    : QWidget(parent),
      tabs_(new QTabBar(this)),
      gridShown_(new QCheckBox(tr("&Grid"), this)),
      note_(new QLabel(tr("The parameters have changed since this was solved."), this)),
      pages_(new QStackedWidget(this)),
      shape_(new SurfacePage(this)),
      maps_(new FieldsView(this)),
      modes_(new ModesPage(touchdown::modes, this)),
      series_(new SeriesPage(steady, this))
{
    for (const QString& name : {tr("Surface"), tr("Pressure"), tr("Gap"), tr("Recess"), tr("Modes"), tr("Series")})
        tabs_->addTab(name);
    using Colours = MapKind::Colours;
    using Logarithm = MapKind::Logarithm;
    maps_->setKinds(
        {{tr("Pressure above ambient"), {"kPa", "atm", "MPa"}, Colours::Signed, Logarithm::Offered, nearAmbient, true},
         {tr("Gap"), {"nm", "um"}, Colours::BrightLow, Logarithm::AtFirst},
         {tr("Recess"), {"nm", "um"}, Colours::Recess}}); // on the pads it is zero: no logarithm
    tabs_->setAccessibleName(tr("Views of the film"));
    tabs_->setDrawBase(false);
    tabs_->setExpanding(false);
    tabs_->setFocusPolicy(Qt::StrongFocus);
    gridShown_->setToolTip(tr("Show the cells of the solver"));
    note_->setContentsMargins(10, 0, 0, 0);
    pages_->addWidget(shape_);
    pages_->addWidget(maps_);
    pages_->addWidget(buildEmptyPage(solve));
    pages_->addWidget(modes_);
    pages_->addWidget(series_);

    auto* row = new QHBoxLayout;
    row->setContentsMargins(6, 4, 8, 4);
    row->setSpacing(8);
    row->addWidget(tabs_);
    row->addWidget(note_);
    row->addStretch(1);
    row->addWidget(maps_->controls());
    row->addWidget(gridShown_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(row);
    layout->addWidget(pages_, 1);

    connect(tabs_, &QTabBar::currentChanged, this, &FilmView::showPage);
    connect(gridShown_, &QCheckBox::toggled, surface(), &SurfaceView::setGridShown);
    connect(gridShown_, &QCheckBox::toggled, maps_->map(), &FieldMap::setGridShown);
    connect(&modes_->controller(), &ModesController::stateChanged, this, &FilmView::busyChanged);
    connect(&series_->controller(), &SeriesController::stateChanged, this, &FilmView::busyChanged);
    setSolving(false);
    showPage();
}

QWidget* FilmView::buildEmptyPage(QAction* solve)
{
    auto* page = new QWidget(this);
    page->setAutoFillBackground(true);
    page->setBackgroundRole(QPalette::Base); // as the plans and plots shown later
    emptyText_ = new QLabel(page);
    auto* button = new QToolButton(page);
    button->setDefaultAction(solve);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setFocusPolicy(Qt::StrongFocus);
    auto* layout = new QVBoxLayout(page);
    layout->addStretch(1);
    layout->addWidget(emptyText_, 0, Qt::AlignHCenter);
    layout->addWidget(button, 0, Qt::AlignHCenter);
    layout->addStretch(2);
    return page;
}

SurfaceView* FilmView::surface() const { return shape_->editor(); }

void FilmView::open(const Case& c)
{
    clearResult();
    modes_->clear();
    series_->open(c);
    setCase(c);
}

void FilmView::setCase(const Case& c)
{
    shape_->setCase(c);
    modes_->setCase(c);
    series_->setCase(c);
}

void FilmView::setResult(const Case& solved, const SteadyResult& result)
{
    solved_ = !result.pressure.empty();
    stale_ = false;
    minimumAt_ = solved_ ? std::optional(result.minimumAt) : std::nullopt;
    minimumSpacing_ = result.minimumSpacing;
    maps_->map()->setSlider(solved.slider.length, solved.slider.width);
    maps_->map()->setSkew(solved.disk.skew);
    maps_->proposeSectionPoint(nearestTheDisk(result));
    std::vector<double> pressure = result.pressure;
    for (double& value : pressure) value -= airOf(solved.air).pressure;
    maps_->setFields(result.grid, {std::move(pressure), result.gap, result.recess});
    surface()->setGrid(result.grid);
    showPage();
}

void FilmView::clearResult()
{
    solved_ = false;
    stale_ = false;
    minimumAt_.reset();
    maps_->proposeSectionPoint(std::nullopt);
    maps_->setFields({}, {});
    surface()->setGrid({});
    showPage();
}

void FilmView::setStale(bool stale)
{
    if (stale == stale_) return;
    stale_ = stale;
    showPage();
}

void FilmView::setSolving(bool solving)
{
    emptyText_->setText(solving ? tr("Solving…") : tr("There is no solution yet."));
}

bool FilmView::busy() const
{
    using State = CalculationController::State;
    return modes_->controller().state() == State::Running || series_->controller().state() == State::Running;
}

void FilmView::stop()
{
    modes_->controller().stop();
    series_->controller().stop();
}

void FilmView::setPage(Page page) { tabs_->setCurrentIndex(static_cast<int>(page)); }

void FilmView::fit()
{
    surface()->fit();
    maps_->fit();
    series_->fit();
}

void FilmView::showPage()
{
    const bool shaping = page() == Page::Surface;
    const bool own = page() == Page::Modes || page() == Page::Series; // they have results of their own
    const bool mapped = !shaping && !own;
    if (mapped) maps_->setField(tabs_->currentIndex() - 1); // the maps have the same order as their tabs
    pages_->setCurrentIndex(shaping ? 0 : page() == Page::Modes ? 3 : page() == Page::Series ? 4 : solved_ ? 1 : 2);
    maps_->controls()->setVisible(mapped && solved_);
    gridShown_->setVisible(!own);
    gridShown_->setEnabled(solved_);
    setTextColour(note_, meaningColours(palette()).warning);
    note_->setVisible(solved_ && stale_ && mapped);
    // The minimum spacing is that of the solved surface.
    surface()->setMinimumSpacing(stale_ ? std::nullopt : minimumAt_, minimumSpacing_);
}

} // namespace touchdown
