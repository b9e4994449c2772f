// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window for a lecture: the whole screen, without panes and menus; text, icons and curves grow with the screen;
// keys go through the steps of the lesson or the demonstrations. When it ends, every part has its size again.
#pragma once

#include <QAction>
#include <QByteArray>
#include <QLabel>
#include <QMainWindow>
#include <QRect>
#include <QToolBar>

namespace touchdown {

class Guides;
class RunView;
class WindowActions;
class WindowPages;
class Workbench;

class Presenter : public QObject {
    Q_OBJECT

public:
    /// All must outlive this.
    Presenter(QMainWindow& window, Workbench& bench, WindowActions& actions, WindowPages& pages, Guides& guides);

    void set(bool on);
    bool on() const { return on_; }
    /// Of the font while it is on [pt].
    int pointSize() const { return pointSize_; }
    /// What is shown, above the page.
    void showCaption();

    QToolBar* bar() const { return bar_; }
    QAction* next() const { return next_; }
    QAction* back() const { return back_; }

signals:
    /// The font changes.
    void changed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void begin();
    void end();
    void arrange();

    RunView& view() const;

    QMainWindow& window_;
    Workbench& bench_;
    WindowActions& actions_;
    WindowPages& pages_;
    Guides& guides_;
    QToolBar* bar_;
    QLabel* caption_;
    QAction *next_, *back_, *leave_;
    bool on_ = false;
    int pointSize_ = 0;
    bool arranging_ = false; // the window has not its former size again
    Qt::WindowStates state_;
    QRect geometry_;
    QByteArray panes_, parts_;
    bool staged_ = false; // the parts are those of a stage
};

} // namespace touchdown
