// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window_pages.h"

#include <utility>

#include <QStatusBar>
#include <QVBoxLayout>

namespace touchdown {

WindowPages::WindowPages(const Parts& parts)
    : QObject(&parts.window), parts_(parts), tabs_(new QTabBar(&parts.window)), pages_(new QStackedWidget(&parts.window))
{
    buildCentre();
    buildPanes();
    parts_.window.statusBar()->addWidget(parts_.runs.progress(), 1);
    parts_.window.statusBar()->addWidget(parts_.film.progress(), 1);
    parts_.window.statusBar()->setSizeGripEnabled(false);
    connect(tabs_, &QTabBar::currentChanged, this, [this] { showModel(model_); });
    // What comes into the list is there to be seen.
    connect(&parts_.runs.runs(), &RunsModel::added, this, [this] { setPage(Page::Run); });
}

void WindowPages::buildCentre()
{
    pages_->addWidget(parts_.runs.view());
    pages_->addWidget(parts_.film.view());

    for (const QString& name : {tr("Static state"), tr("Run in time")}) tabs_->addTab(name);
    tabs_->setAccessibleName(tr("What is shown of the film"));
    tabs_->setExpanding(false);
    tabs_->setFocusPolicy(Qt::StrongFocus);
    tabs_->hide();

    auto* centre = new QWidget(&parts_.window);
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(tabs_);
    layout->addWidget(pages_, 1);
    layout->addWidget(&parts_.messages);
    parts_.window.setCentralWidget(centre);
}

void WindowPages::buildPanes()
{
    QMainWindow& window = parts_.window;
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    QDockWidget* parameters = addPane(QStringLiteral("parameters"), tr("Parameters"), &parts_.casePanel, Qt::LeftDockWidgetArea);
    about_ = addPane(QStringLiteral("about"), tr("About this case"), &parts_.aboutCase, Qt::RightDockWidgetArea);
    QDockWidget* runs = addPane(QStringLiteral("runs"), tr("Runs"), parts_.runs.panel(), Qt::RightDockWidgetArea);
    QDockWidget* values = addPane(QStringLiteral("values"), tr("Values at the cursors"), parts_.runs.values(), Qt::RightDockWidgetArea);
    QDockWidget* attitude = addPane(QStringLiteral("attitude"), tr("Static attitude"), parts_.film.attitude(), Qt::RightDockWidgetArea);
    window.resizeDocks({parameters, about_}, {340, 340}, Qt::Horizontal);
    window.resizeDocks({about_, runs, values}, {280, 240, 260}, Qt::Vertical);
    runPanes_ = {runs, values};
    staticPanes_ = {attitude};
    openPanes_ = staticPanes_;
    attitude->hide();
    attitude->toggleViewAction()->setVisible(false);
    parts_.film.progress()->hide();
}

QDockWidget* WindowPages::addPane(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area)
{
    auto* dock = new QDockWidget(title, &parts_.window);
    dock->setObjectName(name);
    dock->setWidget(content);
    dock->setAccessibleName(title);
    parts_.window.addDockWidget(area, dock);
    parts_.actions.panes->addAction(dock->toggleViewAction());
    return dock;
}

void WindowPages::showModel(ModelKind model)
{
    const bool film = model == ModelKind::Film;
    model_ = model;
    tabs_->setVisible(film);
    showPage(film && tabs_->currentIndex() == static_cast<int>(Page::StaticState));
}

void WindowPages::showPage(bool staticState)
{
    const bool before = std::exchange(staticShown_, staticState);
    parts_.actions.setPage(model_, staticState);
    emit shown();
    if (staticState == before) return;
    pages_->setCurrentWidget(staticState ? static_cast<QWidget*>(parts_.film.view()) : parts_.runs.view());
    const std::vector<QDockWidget*> coming = std::exchange(openPanes_, {});
    for (QDockWidget* pane : staticState ? runPanes_ : staticPanes_) {
        if (!pane->isHidden()) openPanes_.push_back(pane);
        pane->hide();
        pane->toggleViewAction()->setVisible(false);
    }
    for (QDockWidget* pane : staticState ? staticPanes_ : runPanes_) pane->toggleViewAction()->setVisible(true);
    for (QDockWidget* pane : coming) pane->show();
    // The tables are long, and what a film case says about itself is short.
    if (staticState) parts_.window.resizeDocks({about_, staticPanes_.front()}, {180, 560}, Qt::Vertical);
}

void WindowPages::hideStaticPanes()
{
    for (QDockWidget* pane : staticPanes_) pane->hide();
}

void WindowPages::updateProgress()
{
    parts_.runs.progress()->setVisible(!staticShown_ || parts_.runs.controller().active());
    parts_.film.progress()->setVisible(staticShown_ || parts_.film.controller().active());
}

} // namespace touchdown
