// SPDX-License-Identifier: GPL-3.0-or-later
//
// What stands around the case: in the centre the page of runs over time and that of a film's static state, beside them panes, which
// come and go with their page, and the progress of both at the foot.
#pragma once

#include <QDockWidget>
#include <QMainWindow>
#include <QStackedWidget>
#include <QTabBar>

#include <vector>

#include "ui/about_case_pane.h"
#include "ui/case_panel.h"
#include "ui/film_window.h"
#include "ui/message_strip.h"
#include "ui/run_window.h"
#include "ui/window_actions.h"

namespace touchdown {

class WindowPages : public QObject {
    Q_OBJECT

public:
    /// All must outlive this.
    struct Parts {
        QMainWindow& window;
        WindowActions& actions;
        RunWindow& runs;
        FilmWindow& film;
        CasePanel& casePanel;
        AboutCasePane& aboutCase;
        MessageStrip& messages;
    };
    /// Builds centre, panes and foot of the window.
    explicit WindowPages(const Parts& parts);

    /// A film has both; any other case runs in time only.
    enum class Page { StaticState, Run };
    void setPage(Page page) { tabs_->setCurrentIndex(static_cast<int>(page)); }
    /// Offers what the model has.
    void showModel(ModelKind model);
    ModelKind model() const { return model_; }
    /// The panes of the static state come with a film.
    void hideStaticPanes();
    /// That of the page; and of the other one while something is under way there.
    void updateProgress();

    QTabBar* tabs() const { return tabs_; }
    QStackedWidget* pages() const { return pages_; }

signals:
    /// Another model or another page may be shown.
    void shown();

private:
    void buildCentre();
    void buildPanes();
    QDockWidget* addPane(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area);
    /// Brings the page and the panes of the static state, or those of the runs.
    void showPage(bool staticState);

    Parts parts_;
    QTabBar* tabs_;
    QStackedWidget* pages_;
    QDockWidget* about_ = nullptr;
    std::vector<QDockWidget*> runPanes_;    // of a run over time
    std::vector<QDockWidget*> staticPanes_; // of a static state
    std::vector<QDockWidget*> openPanes_;   // of the page that is not shown: those that come back with it
    ModelKind model_ = ModelKind::Springs;
    bool staticShown_ = false;
};

} // namespace touchdown
