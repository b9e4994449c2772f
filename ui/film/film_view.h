// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of a film case: the air bearing surface as it is designed, the fields of a static solution, and solutions
// side by side.
#pragma once

#include <optional>

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QTabBar>
#include <QWidget>

#include "core/case/case.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown {

class ComparePage;
class FieldsView;
class ModesPage;
class SeriesPage;
class SurfacePage;
class SurfaceView;
struct SolutionRecord;

class FilmView : public QWidget {
    Q_OBJECT

public:
    enum class Page { Surface, Pressure, Gap, Recess, Compare, Modes, Series };
    Q_ENUM(Page)

    /// `solve` is offered where there is no result to show.
    explicit FilmView(QAction* solve, QWidget* parent = nullptr);

    /// Another case was opened.
    void open(const Case& c);
    /// The case as it is edited.
    void setCase(const Case& c);
    /// The solved case and its result.
    void setResult(const Case& solved, const SteadyResult& result);
    void clearResult();
    /// Beside the result, which is `shown`: solutions in the sections and in the table, and the one whose fields may be
    /// subtracted. nullptr: nothing is shown; -1: there is no baseline.
    void compare(const SolutionRecord* shown, const std::vector<const SolutionRecord*>& compared, int baseline);
    /// The case is no longer the one that was solved.
    void setStale(bool stale);

    /// The solver is active: the page shows it while there is no result.
    void setSolving(bool solving);

    /// Modes or a series are being sought.
    bool busy() const;
    /// Ends them.
    void stop();
    void stopAndWait();

    void setPage(Page page);
    Page page() const { return static_cast<Page>(tabs_->currentIndex()); }
    void fit();

    SurfaceView* surface() const;
    SurfacePage* shape() const { return shape_; }
    FieldsView* maps() const { return maps_; }
    ComparePage* comparison() const { return compare_; }
    QCheckBox* difference() const { return difference_; }
    ModesPage* modes() const { return modes_; }
    SeriesPage* series() const { return series_; }

signals:
    void busyChanged();
    /// The user or the program went to another page.
    void pageChanged();

private:
    QWidget* buildEmptyPage(QAction* solve);
    void showFields();
    void showPage();

    QTabBar* tabs_;
    QHBoxLayout* row_; // tabs and what belongs to the maps
    QCheckBox *gridShown_, *difference_;
    QLabel* note_;
    QStackedWidget* pages_;
    SurfacePage* shape_;
    FieldsView* maps_;
    ComparePage* compare_;
    ModesPage* modes_;
    SeriesPage* series_;
    QLabel* emptyText_ = nullptr;
    struct Shown {
        Case value;
        SteadyResult result;
    };
    std::optional<Shown> state_; // that is shown, with its fields
    std::optional<Shown> base_;  // that may be subtracted
    bool stale_ = false;
};

} // namespace touchdown
