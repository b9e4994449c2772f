// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/film_view.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/simulation/static_state/steady.h"
#include "ui/maps/field_map.h"
#include "ui/maps/maps_view.h"
#include "ui/slider/surface_view.h"
#include "ui/style/theme.h"

namespace touchdown {

FilmView::FilmView(QAction* solve, QWidget* parent)
    : QWidget(parent),
      tabs_(new QTabBar(this)),
      gridShown_(new QCheckBox(tr("&Grid"), this)),
      note_(new QLabel(tr("The parameters have changed since this was solved."), this)),
      pages_(new QStackedWidget(this)),
      surface_(new SurfaceView(this)),
      maps_(new MapsView(this)),
      empty_(buildEmptyPage(solve))
{
    for (const QString& name : {tr("Surface"), tr("Pressure"), tr("Gap"), tr("Recess")}) tabs_->addTab(name);
    tabs_->setAccessibleName(tr("Views of the film"));
    tabs_->setDrawBase(false);
    tabs_->setExpanding(false);
    tabs_->setFocusPolicy(Qt::StrongFocus);
    gridShown_->setToolTip(tr("Show the cells of the solver"));
    note_->setContentsMargins(10, 0, 0, 0);
    for (QWidget* page : {static_cast<QWidget*>(surface_), static_cast<QWidget*>(maps_), empty_})
        pages_->addWidget(page);

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
    connect(gridShown_, &QCheckBox::toggled, surface_, &SurfaceView::setGridShown);
    connect(gridShown_, &QCheckBox::toggled, maps_->map(), &FieldMap::setGridShown);
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

void FilmView::setCase(const Case& c)
{
    surface_->setSurface(c.surface, c.slider.length, c.slider.width);
    surface_->setSkew(c.disk.skew);
}

void FilmView::setResult(const Case& solved, const SteadyResult& result)
{
    solved_ = !result.pressure.empty();
    stale_ = false;
    minimumAt_ = solved_ ? std::optional(result.minimumAt) : std::nullopt;
    minimumSpacing_ = result.minimumSpacing;
    maps_->setResult(result, solved.slider, solved.disk.skew, ambientPressure(solved));
    surface_->setGrid(result.grid);
    showPage();
}

void FilmView::clearResult()
{
    solved_ = false;
    stale_ = false;
    minimumAt_.reset();
    maps_->clear();
    surface_->setGrid({});
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

void FilmView::setPage(Page page) { tabs_->setCurrentIndex(static_cast<int>(page)); }

void FilmView::fit()
{
    surface_->fit();
    maps_->fit();
}

void FilmView::showPage()
{
    const bool surface = page() == Page::Surface;
    switch (page()) {
    case Page::Surface: break;
    case Page::Pressure: maps_->setQuantity(MapsView::Quantity::Pressure); break;
    case Page::Gap: maps_->setQuantity(MapsView::Quantity::Gap); break;
    case Page::Recess: maps_->setQuantity(MapsView::Quantity::Recess); break;
    }
    pages_->setCurrentWidget(surface   ? static_cast<QWidget*>(surface_)
                             : solved_ ? static_cast<QWidget*>(maps_)
                                       : empty_);
    maps_->controls()->setVisible(!surface && solved_);
    gridShown_->setEnabled(solved_);
    QPalette ofNote;
    ofNote.setColor(QPalette::WindowText, meaningColours(palette()).warning);
    note_->setPalette(ofNote);
    note_->setVisible(solved_ && stale_ && !surface);
    // The least spacing belongs to the surface that was solved, not to another one.
    surface_->setMinimumSpacing(stale_ ? std::nullopt : minimumAt_, minimumSpacing_);
}

} // namespace touchdown
