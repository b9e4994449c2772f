// SPDX-License-Identifier: GPL-3.0-or-later
//
// The film's part of the window: its page, the pane with the static attitude, the progress, and the solver between
// them.
#pragma once

#include <optional>

#include <QAction>
#include <QTimer>

#include "core/simulation/static_state/steady_near.h"
#include "ui/film/influence_controller.h"
#include "ui/film/shape_follower.h"
#include "ui/film/steady_controller.h"

namespace touchdown {

class AttitudeTable;
class FilmView;
class ProgressStrip;

class FilmWindow : public QObject {
    Q_OBJECT

public:
    /// `solve` is the action that starts the solution.
    FilmWindow(SteadyController::Solver solver, QAction* solve, QWidget* parent,
               ShapeFollower::Solver near = steadyNear);

    FilmView* view() const { return view_; }
    AttitudeTable* attitude() const { return attitude_; }
    ProgressStrip* progress() const { return progress_; }
    SteadyController& controller() { return controller_; }

    /// Another case was opened: its result is not known.
    void open(const Case& c);
    /// The case as it is edited.
    void edit(const Case& c);
    /// Solves for the static state, or, when `given`, for the pressure at the attitude of the start.
    void solve(const Case& c, bool given);

    /// The latest solution; nothing before the first.
    const std::optional<SteadyResult>& result() const { return result_; }
    bool stale() const { return stale_; }

signals:
    /// The surface was changed in the plan or in its list: the case is to have it. See SurfaceEditor::edited.
    void surfaceEdited(const touchdown::AirBearingSurface& surface, const QString& text, int merge);
    /// Everything shows it by now.
    void solved(const touchdown::SteadyResult& result);

private:
    void onFinished(const SteadyResult& result);
    void onPreviewed(const AirBearingSurface& surface);
    void onFollowed(const SteadyResult& result);
    void updateInfluence();
    void forgetPreviews();
    void onSurfaceEdited(const AirBearingSurface& surface, const QString& text, int merge);
    /// Solves on the case's own grid once the hand rests.
    void followEdit();
    void updateStale();

    SteadyController controller_;
    FilmView* view_;
    AttitudeTable* attitude_;
    ProgressStrip* progress_;
    ShapeFollower* follower_;
    QTimer restTimer_; // since the last edit of the shape
    InfluenceController influence_;
    QTimer influenceTimer_;                       // since the last edit or selection
    std::optional<SteadyResult> reference_;       // the state before the last edit of the shape
    std::optional<SteadyResult> coarseReference_; // of the case itself on the grid of previews
    std::optional<Case> preview_;                 // waits for that one
    Case edited_;                                 // as it is now
    Case asked_;                                  // of the solution under way, as it was edited
    Case solved_;                                 // of the result
    std::optional<SteadyResult> result_;
    bool stale_ = false;
};

} // namespace touchdown
