// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of a film case: the air bearing surface as it is designed, and the fields of its static state.
#pragma once

#include <optional>

#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QStackedWidget>
#include <QTabBar>
#include <QWidget>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

class FieldsView;
class ModesPage;
class SeriesPage;
class SurfacePage;
class SurfaceView;
struct Case;
struct SteadyResult;

class FilmView : public QWidget {
    Q_OBJECT

public:
    enum class Page { Surface, Pressure, Gap, Recess, Modes, Series };
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
    /// The case is no longer the one that was solved.
    void setStale(bool stale);

    /// The solver is active: the page shows it while there is no result.
    void setSolving(bool solving);

    /// Modes or a series are being sought.
    bool busy() const;
    /// Ends them.
    void stop();

    void setPage(Page page);
    Page page() const { return static_cast<Page>(tabs_->currentIndex()); }
    void fit();

    SurfaceView* surface() const;
    SurfacePage* shape() const { return shape_; }
    FieldsView* maps() const { return maps_; }
    ModesPage* modes() const { return modes_; }
    SeriesPage* series() const { return series_; }

signals:
    void busyChanged();

private:
    QWidget* buildEmptyPage(QAction* solve);
    void showPage();

    QTabBar* tabs_;
    QCheckBox* gridShown_;
    QLabel* note_;
    QStackedWidget* pages_;
    SurfacePage* shape_;
    FieldsView* maps_;
    ModesPage* modes_;
    SeriesPage* series_;
    QLabel* emptyText_ = nullptr;
    bool solved_ = false;
    bool stale_ = false;
    std::optional<SurfacePoint> minimumAt_;
    double minimumSpacing_ = 0.0; // [m]
};

} // namespace touchdown
