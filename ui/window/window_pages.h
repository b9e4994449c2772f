// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout of the window: in the centre the pages of runs over time, of a film's static state and of studies; at the
// sides panes, which belong to some of the pages; at the foot the progress of each calculation.
#pragma once

#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

#include <map>
#include <optional>
#include <vector>

#include "core/case/case.h"
#include "ui/workbench/workbench.h"

namespace touchdown {

class AboutCasePane;
class CasePanel;
class StartCard;
class WindowActions;

class WindowPages : public QObject {
    Q_OBJECT

public:
    /// All must outlive this.
    struct Parts {
        QMainWindow& window;
        WindowActions& actions;
        RunWindow& runs;
        FilmWindow& film;
        StudyWindow& studies;
        CasePanel& casePanel;
        AboutCasePane& aboutCase;
        MessageStrip& messages;
        StartCard& start;
    };
    /// Builds centre, panes and foot of the window.
    explicit WindowPages(const Parts& parts);

    using Page = Workbench::Page;
    /// Only the model film has the page of the static state; other cases show the run in time instead.
    void setPage(Page page);
    Page page() const { return static_cast<Page>(tabs_->currentIndex()); }
    /// Offers what the model has.
    void showModel(ModelKind model);
    ModelKind model() const { return model_; }
    /// Only the panes of the page that is shown, as after an arrangement was restored.
    void showPanesOfPage();
    /// A pane that guides the reader, beside the description of the case; `name` of its dock.
    void showGuide(QWidget& guide, const QString& name, const QString& title);
    void hideGuide(QWidget& guide);
    /// For a lecture: all panes are hidden, and come back, arranged as the window had saved it.
    void hidePanes();
    void bringPanesBack(const QByteArray& arrangement);
    /// The page has the whole window, until the panes come back as they were.
    void showAlone(bool on);
    /// Below the page, which makes room for it.
    void addFoot(QWidget& foot);
    /// Over the lower edge of the page, which stays as it is.
    void addNotice(QWidget& notice);
    /// The progress of the shown page, and of other pages with an active calculation.
    void updateProgress();
    /// Where the user has not arranged the panes: the page has half of the window, and in a low one the solutions stand
    /// over the description of the case.
    void arrangeAtFirst();
    /// Panes and pages ask for no more room than the screen has, however large the font is.
    void limitSizes();
    /// What the runs of the list take of the memory; hidden without runs.
    QLabel* memory() const { return memory_; }
    /// Says, while it is shown, that the work is not kept against a crash.
    QLabel* notKept() const { return notKept_; }

    QStackedWidget* pages() const { return pages_; }

signals:
    /// Another model or another page may be shown.
    void shown();
    /// The pane of a guide was opened or closed; not while all are hidden.
    void guideToggled(QWidget* guide, bool open);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void buildCentre();
    void buildPanes();
    QDockWidget* addPane(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area);
    void showPage();
    void noteWanted();
    void makeRoomForGuide();
    void placeNotices();
    /// Shape and static attitude share a place: the plan wants the one, the other views the other.
    void raisePaneOfView();
    struct Guide {
        QWidget* widget = nullptr;
        QString name, title;
        bool isNew = false;              // its pane has no place in an arrangement yet
        bool takesPlaceOfValues = false; // these become a tab beside the runs
    };
    void openGuide(const Guide& guide);
    bool wantsPlaceOfValues() const;

    Parts parts_;
    QTabBar* tabs_;
    QVBoxLayout* centre_ = nullptr;
    QStackedWidget* pages_;
    QWidget* notices_ = nullptr; // over the lower edge of the pages
    QLabel *memory_, *notKept_;
    QDockWidget *parameters_ = nullptr, *about_ = nullptr, *runs_ = nullptr, *values_ = nullptr;
    struct Pane {
        QDockWidget* dock = nullptr;
        std::vector<Page> pages; // that show it
        bool wanted = true;      // the user did not close it
    };
    std::vector<Pane> panes_; // those that belong to some pages
    QDockWidget *solutions_ = nullptr, *attitude_ = nullptr, *shape_ = nullptr;
    QDockWidget* study_ = nullptr;
    bool panesHidden_ = false;
    QByteArray arrangement_;                  // while a page is shown alone
    std::vector<QDockWidget*> hiddenPanes_;   // meanwhile
    std::optional<Guide> meanwhile_;          // that was asked for meanwhile: its pane opens with the others
    std::map<QWidget*, QDockWidget*> guides_; // those that were asked for
    ModelKind model_ = ModelKind::Springs;
    Page shown_ = Page::Run;
};

} // namespace touchdown
