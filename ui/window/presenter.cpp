// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/presenter.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QEvent>
#include <QMenuBar>
#include <QScreen>
#include <QStatusBar>
#include <QTimer>

#include "ui/case/case_edits.h"
#include "ui/guides/guides.h"
#include "ui/runs/run_view.h"
#include "ui/runs/run_window.h"
#include "ui/style/foreign_text.h"
#include "ui/style/readable.h"
#include "ui/style/theme.h"
#include "ui/window/window_actions.h"
#include "ui/window/window_pages.h"
#include "ui/workbench/workbench.h"

namespace touchdown {

namespace {

constexpr double linesOnScreen = 34.0; // of text, from the top of the screen to its foot
constexpr double iconLines = 1.3;      // height of an icon in lines of text
constexpr double pointsPerInch = 72.0;
constexpr int longestWait = 2000; // for the former size of the window [ms]

} // namespace

Presenter::Presenter(QMainWindow& window, Workbench& bench, WindowActions& actions, WindowPages& pages, Guides& guides)
    : QObject(&window),
      window_(window),
      bench_(bench),
      actions_(actions),
      pages_(pages),
      guides_(guides),
      bar_(new QToolBar(tr("Presenter"), &window)),
      caption_(new QLabel(bar_)),
      next_(new QAction(tr("Next"), this)),
      back_(new QAction(tr("Back"), this)),
      leave_(new QAction(tr("Leave"), this))
{
    next_->setShortcuts({QKeySequence(Qt::Key_PageDown)});
    back_->setShortcuts({QKeySequence(Qt::Key_PageUp)});
    next_->setToolTip(tr("The next step of the lesson or the demonstrations (Page Down)"));
    back_->setToolTip(tr("The step before it (Page Up)"));
    bar_->setObjectName(QStringLiteral("presenter"));
    bar_->setMovable(false);
    caption_->setTextFormat(Qt::RichText);
    caption_->setAccessibleName(tr("What is shown"));
    caption_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    caption_->setMinimumWidth(60);
    caption_->setContentsMargins(12, 0, 12, 0);
    bar_->addAction(back_);
    bar_->addWidget(caption_);
    bar_->addAction(next_);
    bar_->addSeparator();
    bar_->addActions({actions.run, actions.pause, actions.step, actions.presenter});
    window_.addToolBar(bar_);
    bar_->hide();
    // Not among the panes that the user shows and hides.
    bar_->toggleViewAction()->setVisible(false);
    leave_->setShortcut(Qt::Key_Escape);
    for (QAction* action : {next_, back_, leave_}) {
        action->setEnabled(false);
        window_.addAction(action);
    }
    connect(leave_, &QAction::triggered, this, [this] { actions_.presenter->setChecked(false); });
    connect(next_, &QAction::triggered, this, [this] { guides_.go(1); });
    connect(back_, &QAction::triggered, this, [this] { guides_.go(-1); });
    window_.installEventFilter(this);
}

RunView& Presenter::view() const { return *bench_.runWindow().view(); }

void Presenter::set(bool on)
{
    if (on == on_) return;
    on ? begin() : end();
}

void Presenter::begin()
{
    arranging_ = false;
    state_ = window_.windowState();
    geometry_ = window_.geometry();
    panes_ = window_.saveState();
    parts_ = view().splitter()->saveState();
    staged_ = view().stage().has_value();
    on_ = true;
    const QScreen* screen = window_.screen();
    const double pixels = screen->geometry().height() / linesOnScreen;
    pointSize_ = std::max(systemPointSize() + 2,
                          static_cast<int>(std::floor(0.75 * pixels * pointsPerInch / screen->logicalDotsPerInch())));
    pages_.hidePanes();
    window_.menuBar()->hide();
    window_.statusBar()->hide();
    actions_.toolBar->hide();
    const int icon = static_cast<int>(std::lround(iconLines * pixels));
    bar_->setIconSize({icon, icon});
    bar_->show();
    for (QAction* action : {next_, back_, leave_}) action->setEnabled(true);
    actions_.findParameter->setEnabled(false); // its pane is hidden
    guides_.present(true);
    emit changed();
    showCaption();
    window_.showFullScreen();
}

void Presenter::end()
{
    on_ = false;
    for (QAction* action : {next_, back_, leave_}) action->setEnabled(false);
    actions_.findParameter->setEnabled(true);
    bar_->hide();
    guides_.present(false);
    emit changed();
    QCoreApplication::sendPostedEvents(); // the parts have their former font, and need no more room than before
    actions_.toolBar->show();
    window_.menuBar()->show();
    window_.statusBar()->show();
    arranging_ = true;
    window_.setWindowState(state_);
    window_.setVisible(true);
    if (!(state_ & (Qt::WindowMaximized | Qt::WindowFullScreen))) window_.setGeometry(geometry_);
    QCoreApplication::sendPostedEvents();
    arrange();
    QTimer::singleShot(longestWait, this, [this] { arranging_ = false; });
}

void Presenter::arrange()
{
    pages_.bringPanesBack(panes_);
    if (view().stage().has_value() == staged_) view().splitter()->restoreState(parts_);
    arranging_ = window_.size() != geometry_.size();
}

void Presenter::showCaption()
{
    const LessonPane* guide = guides_.shown();
    const QString title = guide ? QString::fromStdString(guide->shown().title) : readable(bench_.edits().value().title);
    caption_->setText(QStringLiteral("<b>%1</b>").arg(escaped(title)));
    for (QAction* action : {next_, back_}) action->setVisible(guide != nullptr);
}

bool Presenter::eventFilter(QObject* watched, QEvent* event)
{
    // The window manager gives the former size back after a while.
    if (arranging_ && event->type() == QEvent::Resize && window_.size() == geometry_.size()) arrange();
    return QObject::eventFilter(watched, event);
}

} // namespace touchdown
