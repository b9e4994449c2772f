// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_pages.h"

#include <algorithm>
#include <utility>

#include <QChildEvent>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QVBoxLayout>

#include "ui/calculation/progress_strip.h"
#include "ui/case/case_panel.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/surface_page.h"
#include "ui/lists/record_panel.h"
#include "ui/plot/cursor_table.h"
#include "ui/runs/about_case_pane.h"
#include "ui/runs/run_view.h"
#include "ui/runs/run_window.h"
#include "ui/slider/attitude_table.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_results.h"
#include "ui/studies/study_window.h"
#include "ui/style/foreign_text.h"
#include "ui/style/message_strip.h"
#include "ui/window/start_card.h"
#include "ui/window/window_actions.h"

namespace touchdown {

namespace {

// The most that is asked for, of the screen: a pane at the left, three at the right, the page between them.
constexpr double widestPane = 0.245, widestPage = 0.44;
constexpr double highestPane = 0.18, highestPage = 0.7;
constexpr int lowWindow = 850;                                           // [px]
constexpr QLatin1String valuesMoved("window/valuesShareThePlaceOfRuns"); // by the program

} // namespace

WindowPages::WindowPages(const Parts& parts)
    : QObject(&parts.window),
      parts_(parts),
      tabs_(new QTabBar(&parts.window)),
      pages_(new QStackedWidget(&parts.window)),
      memory_(new QLabel(&parts.window)),
      notKept_(new QLabel(tr("⚠ Not kept"), &parts.window))
{
    parts_.window.installEventFilter(this); // it makes bars of its own for panes that share a place
    buildCentre();
    buildPanes();
    parts_.window.statusBar()->addWidget(parts_.runs.progress(), 1);
    parts_.window.statusBar()->addWidget(parts_.film.progress(), 1);
    parts_.window.statusBar()->addWidget(parts_.studies.progress(), 1);
    parts_.window.statusBar()->addPermanentWidget(memory_);
    memory_->setObjectName(QStringLiteral("runMemory"));
    memory_->hide();
    parts_.window.statusBar()->addPermanentWidget(notKept_);
    notKept_->setObjectName(QStringLiteral("notKept"));
    notKept_->hide();
    parts_.window.statusBar()->setSizeGripEnabled(false);
    parts_.window.statusBar()->setContentsMargins(0, 0, 8, 0); // its own layout takes no account of those of a label
    connect(&parts_.runs.memory(), &RunMemory::changed, memory_, [this] {
        memory_->setText(parts_.runs.memory().text());
        memory_->setToolTip(plainTip(parts_.runs.memory().explanation()));
        memory_->setVisible(parts_.runs.runs().count() > 0);
    });
    connect(tabs_, &QTabBar::currentChanged, this, &WindowPages::showPage);
    connect(parts_.film.view(), &FilmView::pageChanged, this, &WindowPages::raisePaneOfView);
    connect(parts_.film.view()->shape(), &SurfacePage::panelWanted, this, [this] {
        parts_.actions.alone->setChecked(false);
        shape_->show();
        shape_->raise();
    });
    // A run that is added to the list is shown.
    connect(&parts_.runs.runs(), &RunsModel::added, this, [this] { setPage(Page::Run); });
}

void WindowPages::buildCentre()
{
    // In the order of Page.
    for (QWidget* page : {static_cast<QWidget*>(parts_.film.view()), static_cast<QWidget*>(parts_.runs.view()),
                          static_cast<QWidget*>(parts_.studies.results())})
        pages_->addWidget(page);
    for (const QString& name : {tr("Static state"), tr("Run in time"), tr("Studies")}) tabs_->addTab(name);
    tabs_->setTabVisible(static_cast<int>(Page::StaticState), false);
    tabs_->setCurrentIndex(static_cast<int>(Page::Run));
    pages_->setCurrentIndex(static_cast<int>(Page::Run));
    tabs_->setObjectName(QStringLiteral("pages"));
    tabs_->setAccessibleName(tr("Pages of the case"));
    tabs_->setExpanding(false);
    tabs_->setFocusPolicy(Qt::StrongFocus);

    auto* centre = new QWidget(&parts_.window);
    centre_ = new QVBoxLayout(centre);
    centre_->setContentsMargins(0, 0, 0, 0);
    centre_->setSpacing(0);
    centre_->addWidget(&parts_.start);
    centre_->addWidget(tabs_);
    centre_->addWidget(pages_, 1);
    centre_->addWidget(&parts_.messages);
    parts_.window.setCentralWidget(centre);
    notices_ = new QWidget(centre);
    auto* notices = new QVBoxLayout(notices_);
    notices->setContentsMargins(0, 0, 0, 0);
    notices->setSpacing(0);
    for (QWidget* watched : {notices_, static_cast<QWidget*>(pages_)}) watched->installEventFilter(this);
}

void WindowPages::addFoot(QWidget& foot) { centre_->addWidget(&foot); }

void WindowPages::addNotice(QWidget& notice)
{
    notice.setAutoFillBackground(true);
    notices_->layout()->addWidget(&notice);
}

bool WindowPages::eventFilter(QObject* watched, QEvent* event)
{
    const auto type = event->type();
    if (watched == &parts_.window && type == QEvent::ChildPolished)
        if (auto* bar = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child()))
            bar->setAccessibleName(tr("Panes in one place"));
    if (watched == &parts_.window) return QObject::eventFilter(watched, event);
    if (watched == notices_ ? type == QEvent::LayoutRequest : type == QEvent::Resize || type == QEvent::Move)
        placeNotices();
    return QObject::eventFilter(watched, event);
}

void WindowPages::placeNotices()
{
    const QRect page = pages_->geometry();
    const int height = notices_->layout()->sizeHint().height();
    notices_->setGeometry(page.left(), page.bottom() + 1 - height, page.width(), height);
    notices_->raise();
}

void WindowPages::buildPanes()
{
    QMainWindow& window = parts_.window;
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    parameters_ = addPane(QStringLiteral("parameters"), tr("Parameters"), &parts_.casePanel, Qt::LeftDockWidgetArea);
    about_ = addPane(QStringLiteral("about"), tr("About this case"), &parts_.aboutCase, Qt::RightDockWidgetArea);
    runs_ = addPane(QStringLiteral("runs"), tr("Runs"), parts_.runs.panel(), Qt::RightDockWidgetArea);
    values_ =
        addPane(QStringLiteral("values"), tr("Values at the cursors"), parts_.runs.values(), Qt::RightDockWidgetArea);
    solutions_ = addPane(QStringLiteral("solutions"), tr("Solutions"), parts_.film.panel(), Qt::RightDockWidgetArea);
    attitude_ =
        addPane(QStringLiteral("attitude"), tr("Static attitude"), parts_.film.attitude(), Qt::RightDockWidgetArea);
    shape_ =
        addPane(QStringLiteral("shape"), tr("Shape"), parts_.film.view()->shape()->panel(), Qt::RightDockWidgetArea);
    window.tabifyDockWidget(attitude_, shape_);
    study_ = addPane(QStringLiteral("study"), tr("Study"), parts_.studies.editor(), Qt::RightDockWidgetArea);
    window.resizeDocks({about_, runs_, values_}, {280, 240, 260}, Qt::Vertical);
    panes_ = {{about_, {Page::StaticState, Page::Run}},
              {runs_, {Page::Run}},
              {values_, {Page::Run}},
              {solutions_, {Page::StaticState}},
              {attitude_, {Page::StaticState}},
              {shape_, {Page::StaticState}},
              {study_, {Page::Studies}}};
    showPanesOfPage();
    parts_.film.progress()->hide();
    parts_.studies.progress()->hide();
}

QDockWidget* WindowPages::addPane(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area)
{
    auto* dock = new QDockWidget(title, &parts_.window);
    dock->setObjectName(name);
    dock->setWidget(content);
    content->show();
    dock->setAccessibleName(title);
    parts_.window.addDockWidget(area, dock);
    parts_.actions.panes->addAction(dock->toggleViewAction());
    return dock;
}

void WindowPages::setPage(Page page)
{
    const bool none = page == Page::StaticState && !tabs_->isTabVisible(static_cast<int>(page));
    tabs_->setCurrentIndex(static_cast<int>(none ? Page::Run : page));
}

void WindowPages::showModel(ModelKind model)
{
    model_ = model;
    const bool film = model == ModelKind::Film;
    if (!film && page() == Page::StaticState) setPage(Page::Run);
    tabs_->setTabVisible(static_cast<int>(Page::StaticState), film);
    parts_.actions.setPage(model_, page() == Page::Run);
    emit shown();
}

void WindowPages::showPage()
{
    noteWanted();
    shown_ = page();
    pages_->setCurrentIndex(static_cast<int>(shown_));
    parts_.actions.setPage(model_, shown_ == Page::Run);
    showPanesOfPage();
    // The table of the attitude is long, the description of a film case is short.
    if (shown_ == Page::StaticState && parts_.window.tabifiedDockWidgets(about_).contains(solutions_))
        parts_.window.resizeDocks({solutions_, attitude_}, {220, 400}, Qt::Vertical);
    else if (shown_ == Page::StaticState)
        parts_.window.resizeDocks({about_, solutions_, attitude_}, {130, 220, 400}, Qt::Vertical);
    QMetaObject::invokeMethod(this, &WindowPages::raisePaneOfView, Qt::QueuedConnection); // when they have their places
    makeRoomForGuide();
    emit shown();
}

void WindowPages::raisePaneOfView()
{
    const bool plan = parts_.film.view()->page() == FilmView::Page::Surface;
    if (QDockWidget* wanted = plan ? shape_ : attitude_; !wanted->isHidden()) wanted->raise();
    const bool guided = std::ranges::any_of(guides_, [](const auto& each) { return !each.second->isHidden(); });
    if (!guided && !solutions_->isHidden()) solutions_->raise();
}

/// Which panes of its page the user left open.
void WindowPages::noteWanted()
{
    for (Pane& pane : panes_)
        if (!panesHidden_ && std::ranges::find(pane.pages, shown_) != pane.pages.end())
            pane.wanted = !pane.dock->isHidden();
}

void WindowPages::showPanesOfPage()
{
    // Those of the former page leave first: all together would need a higher window, which would stay as high.
    for (const bool shown : {false, true})
        for (const Pane& pane : panes_) {
            const bool here = std::ranges::find(pane.pages, shown_) != pane.pages.end();
            pane.dock->toggleViewAction()->setVisible(here);
            if (const bool wanted = here && pane.wanted && !panesHidden_; wanted == shown)
                pane.dock->setVisible(wanted);
        }
}

void WindowPages::showGuide(QWidget& guide, const QString& name, const QString& title)
{
    parts_.actions.alone->setChecked(false);
    const bool isNew = !guides_.contains(&guide);
    const Guide opened{&guide, name, title, isNew, isNew && wantsPlaceOfValues()};
    if (!panesHidden_) return openGuide(opened);
    std::erase_if(hiddenPanes_, [this](const QDockWidget* each) { return guides_.contains(each->widget()); });
    meanwhile_ = opened;
}

void WindowPages::openGuide(const Guide& guide)
{
    QDockWidget*& dock = guides_[guide.widget];
    if (dock == nullptr) {
        dock = addPane(guide.name, guide.title, guide.widget, Qt::RightDockWidgetArea);
        connect(dock->toggleViewAction(), &QAction::toggled, this, [this, widget = guide.widget](bool open) {
            if (!panesHidden_) emit guideToggled(widget, open);
        });
    }
    if (guide.isNew) {
        parts_.window.tabifyDockWidget(about_, dock);
        if (guide.takesPlaceOfValues) {
            parts_.window.tabifyDockWidget(runs_, values_);
            runs_->raise();
            QSettings().setValue(valuesMoved, true);
        }
    }
    dock->show();
    dock->raise();
    makeRoomForGuide();
}

/// In a low window the values share the place of the runs, so that a guide can be read: once, and only where the user
/// left both in the column of the guide.
bool WindowPages::wantsPlaceOfValues() const
{
    const auto inColumn = [this](QDockWidget* dock) {
        return !dock->isFloating() && parts_.window.dockWidgetArea(dock) == Qt::RightDockWidgetArea;
    };
    return parts_.window.height() < lowWindow && inColumn(runs_) && inColumn(values_) &&
           !QSettings().contains(valuesMoved);
}

void WindowPages::hideGuide(QWidget& guide)
{
    if (const auto found = guides_.find(&guide); found != guides_.end()) found->second->hide();
}

void WindowPages::hidePanes()
{
    noteWanted();
    panesHidden_ = true; // before they are hidden: nobody closes them
    hiddenPanes_.clear();
    meanwhile_.reset();
    for (auto* dock : parts_.window.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) {
        if (dock->isHidden()) continue;
        hiddenPanes_.push_back(dock);
        dock->hide();
    }
}

void WindowPages::showAlone(bool on)
{
    if (on == panesHidden_) return;
    parts_.actions.panes->setEnabled(!on);
    if (!on) return bringPanesBack(arrangement_);
    arrangement_ = parts_.window.saveState();
    hidePanes();
}

void WindowPages::bringPanesBack(const QByteArray& arrangement)
{
    panesHidden_ = true;
    parts_.window.restoreState(arrangement);
    panesHidden_ = false;
    showPanesOfPage();
    panesHidden_ = true; // the guides go on as they are
    for (QDockWidget* dock : hiddenPanes_) {
        if (std::ranges::find(panes_, dock, &Pane::dock) != panes_.end()) continue; // of a page
        dock->show();
        dock->raise();
    }
    if (meanwhile_) {
        for (const auto& [guide, dock] : guides_) dock->setVisible(guide == meanwhile_->widget);
        openGuide(*meanwhile_);
    }
    panesHidden_ = false;
}

/// Its text is long, the list of runs is short; a study has a form.
void WindowPages::makeRoomForGuide()
{
    for (const auto& [guide, dock] : guides_)
        if (!dock->isHidden())
            parts_.window.resizeDocks({dock, runs_, values_, study_},
                                      {shown_ == Page::Studies ? 260 : 600, 150, 150, 640}, Qt::Vertical);
}

void WindowPages::arrangeAtFirst()
{
    const int width = std::min(340, static_cast<int>(widestPane * parts_.window.width()));
    parts_.window.resizeDocks({parameters_, about_}, {width, width}, Qt::Horizontal);
    if (parts_.window.height() < lowWindow) parts_.window.tabifyDockWidget(about_, solutions_);
}

void WindowPages::limitSizes()
{
    const QSize screen = parts_.window.screen()->availableGeometry().size();
    const auto limit = [&screen](QWidget* widget, double width, double height) {
        const QSize needed = widget->minimumSizeHint();
        widget->setMinimumSize(std::min(needed.width(), static_cast<int>(width * screen.width())),
                               std::min(needed.height(), static_cast<int>(height * screen.height())));
    };
    for (const auto* dock : parts_.window.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly))
        limit(dock->widget(), widestPane, highestPane);
    limit(parts_.window.centralWidget(), widestPage, highestPage);
}

void WindowPages::updateProgress()
{
    parts_.runs.progress()->setVisible(shown_ == Page::Run || parts_.runs.controller().active());
    parts_.film.progress()->setVisible(shown_ == Page::StaticState || parts_.film.controller().active());
    parts_.studies.progress()->setVisible(shown_ == Page::Studies || parts_.studies.controller().active());
}

} // namespace touchdown
