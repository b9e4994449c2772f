// SPDX-License-Identifier: GPL-3.0-or-later
//
// The film's part of the window: its page, the panes with the solutions and the static attitude, the progress, and the
// solver between them. Every solution is kept; the one that is chosen in the list is shown.
#pragma once

#include <map>
#include <optional>

#include <QAction>
#include <QTimer>

#include "core/simulation/static_state/steady_near.h"
#include "ui/film/influence_controller.h"
#include "ui/film/shape_follower.h"
#include "ui/film/solutions_model.h"
#include "ui/film/steady_controller.h"

namespace touchdown {

class AttitudeTable;
class FilmView;
class ProgressStrip;
class RecordPanel;

class FilmWindow : public QObject {
    Q_OBJECT

public:
    /// `solve` is the action that starts the solution.
    FilmWindow(SteadyController::Solver solver, QAction* solve, QWidget* parent,
               ShapeFollower::Solver near = steadyNear);
    ~FilmWindow() override;

    FilmView* view() const { return view_; }
    AttitudeTable* attitude() const { return attitude_; }
    ProgressStrip* progress() const { return progress_; }
    SolutionsModel& solutions() { return solutions_; }
    RecordPanel* panel() const { return panel_; }
    SteadyController& controller() { return controller_; }

    /// Another case was opened: it is not solved, unless a solution in the list is of the same film.
    void open(const Case& c);
    /// The case as it is edited.
    void edit(const Case& c);
    /// Solves for the static state, or, when `given`, for the pressure at the attitude of the start.
    void solve(const Case& c, bool given);

    /// The solution that is shown; nullptr: none.
    const SteadyResult* result() const;
    const SolutionRecord* shown() const { return solutions_.find(shown_); }
    /// The case of the last solution, or of the one under way.
    const Case& asked() const { return asked_; }
    bool stale() const { return stale_; }
    /// The case that was solved last is the case as it is edited whether or not it has a state.
    bool solvedAsEdited() const { return isEdited(asked_, {}); }

signals:
    /// The surface was changed in the plan or in its list: the case is to have it. See SurfaceEditor::edited.
    void surfaceEdited(const touchdown::AirBearingSurface& surface, const QString& text, int merge);
    /// Another solution is shown, or none, or the case has become that of the solution or has ceased to be: see
    /// `result` and `stale`.
    void shownChanged();
    /// Everything shows it by now.
    void solved(const touchdown::SteadyResult& result);

private:
    /// What the list has of a case: its state, or else a search that found none.
    const SolutionRecord* knownOf(const Case& c) const;
    void show(int number);
    void showComparison();
    /// The line above the plan, when no preview is under way.
    void showFlight();
    /// The state beside the bar of the progress is that of the case as it is edited.
    void showOutcome();
    void conclude(const SteadyResult& result);
    std::optional<SteadyResult> reference() const;
    void onFinished(const SteadyResult& result);
    void onPreviewed(const AirBearingSurface& surface);
    void onFollowed(const SteadyResult& result);
    void updateInfluence();
    void forgetPreviews();
    void onSurfaceEdited(const AirBearingSurface& surface, const QString& text, int merge);
    /// Solves on the case's own grid once the hand rests, where the shape may fly.
    void followEdit();
    /// Why the shape is not solved by itself: its rails cannot carry it, or a search found so before. "": it is solved.
    QString reasonToWait() const;
    /// What was solved, with this attitude, is the case as it is edited.
    bool isEdited(Case solved, const Attitude& found) const;
    void updateStale();

    SteadyController controller_;
    SolutionsModel solutions_;
    FilmView* view_;
    RecordPanel* panel_;
    AttitudeTable* attitude_;
    ProgressStrip* progress_;
    ShapeFollower* follower_;
    QTimer restTimer_; // since the last edit of the shape
    InfluenceController influence_;
    QTimer influenceTimer_;                       // since the last edit or selection
    int before_ = -1;                             // the solution before the last edit of the shape
    std::map<int, int> beforeOf_;                 // the same of each solution, for undo
    std::optional<SteadyResult> coarseReference_; // of the case itself on the grid of previews
    std::optional<Case> preview_;                 // waits for that one
    Case edited_;                                 // as it is now
    Case asked_;                                  // of the solution under way
    bool byItself_ = false;                       // the solution under way follows an edit; nobody asked for it
    std::vector<StaticSolution> fruitless_;       // the last ones of these that found no state, without fields
    int shown_ = -1;                              // number of the solution that is shown
    bool stale_ = false;
};

} // namespace touchdown
