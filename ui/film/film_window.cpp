// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/film_window.h"

#include <utility>

#include "core/case/parameters.h"
#include "core/physics/slider/surface_check.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "ui/calculation/progress_strip.h"
#include "ui/film/film_view.h"
#include "ui/film/same_film.h"
#include "ui/film/surface_page.h"
#include "ui/slider/attitude_sections.h"
#include "ui/slider/attitude_table.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr int restTime = 250; // after the last edit of the shape [ms]

} // namespace

FilmWindow::FilmWindow(SteadyController::Solver solver, QAction* solve, QWidget* parent, ShapeFollower::Solver near)
    : QObject(parent),
      controller_(std::move(solver)),
      view_(new FilmView(solve, parent)),
      attitude_(new AttitudeTable(parent)),
      progress_(new ProgressStrip(controller_, tr("static solution"), tr("Solving"), parent)),
      follower_(new ShapeFollower(std::move(near), this))
{
    connect(&controller_, &SteadyController::stateChanged, view_,
            [this](SteadyController::State state) { view_->setSolving(state != SteadyController::State::Idle); });
    connect(&controller_, &SteadyController::finished, this,
            [this](int, const SteadyResult& result) { onFinished(result); });
    SurfacePage* shape = view_->shape();
    connect(shape, &SurfacePage::previewed, this, &FilmWindow::onPreviewed);
    connect(shape, &SurfacePage::edited, this, &FilmWindow::onSurfaceEdited);
    connect(follower_, &ShapeFollower::followed, this, &FilmWindow::onFollowed);
    connect(shape, &SurfacePage::influenceWanted, this, &FilmWindow::updateInfluence);
    connect(&influence_, &InfluenceController::found, shape, &SurfacePage::showInfluence);
    influenceTimer_.setSingleShot(true);
    connect(&influenceTimer_, &QTimer::timeout, this, [this, shape] {
        if (influence_.active()) // its stop takes a moment
            influenceTimer_.start(restTime);
        else if (checkCombinations(edited_).empty() && edited_.model == ModelKind::Film)
            influence_.start(edited_, shape->influencingParts());
    });
    restTimer_.setSingleShot(true);
    connect(&restTimer_, &QTimer::timeout, this, &FilmWindow::followEdit);
}

void FilmWindow::open(const Case& c)
{
    controller_.stopAndWait();
    result_.reset();
    stale_ = false;
    forgetPreviews();
    restTimer_.stop();
    reference_.reset();
    attitude_->clear();
    edited_ = c;
    view_->open(c);
    view_->shape()->open(c);
    emit view_->shape()->influenceWanted();
    view_->fit();
}

void FilmWindow::forgetPreviews()
{
    follower_->forget();
    coarseReference_.reset();
    preview_.reset();
}

void FilmWindow::edit(const Case& c)
{
    const bool shaped = c.surface != edited_.surface;
    if (edited_ != c) forgetPreviews();
    edited_ = c;
    // Undo and redo are followed, too.
    if (shaped && result_ && view_->shape()->follows()) restTimer_.start(restTime);
    view_->setCase(c);
    emit view_->shape()->influenceWanted();
    updateStale();
}

void FilmWindow::solve(const Case& c, bool given)
{
    restTimer_.stop();
    controller_.stopAndWait();
    asked_ = c;
    Case wanted = c;
    wanted.steady.fixedAttitude = wanted.steady.fixedAttitude || given;
    controller_.start(std::move(wanted));
}

void FilmWindow::onFinished(const SteadyResult& result)
{
    QString text;
    if (!result.grid.x.empty())
        text = tr("%1 × %2 cells · %3 iterations · residual %4 · %5")
                   .arg(result.grid.nx())
                   .arg(result.grid.ny())
                   .arg(QLocale().toString(result.iterations), roundedText(result.residual, "", 2),
                        timeText(result.wallSeconds));
    else if (result.status == SteadyStatus::Failed)
        text = steadyText(result); // why there can be no static state
    progress_->conclude(name(result.status), text);
    // A solution that ended without a field does not replace the last result.
    if (!result.pressure.empty() || !result_) {
        result_ = result;
        solved_ = asked_;
        view_->setResult(solved_, result);
        attitude_->setResult(solved_, result);
        view_->shape()->showFlight(result, reference_, false);
        updateStale();
    }
    emit solved(result);
}

void FilmWindow::onPreviewed(const AirBearingSurface& surface)
{
    if (!view_->shape()->follows()) return;
    if (view_->shape()->editor()->dragging()) controller_.stop();
    restTimer_.stop();
    // A gesture that is given up has stopped what was being solved.
    if (!view_->shape()->editor()->dragging() && stale_) restTimer_.start(restTime);
    Case preview = edited_;
    preview.surface = surface;
    if (const auto problems = surfaceProblems(surface); !problems.empty()) {
        view_->shape()->showObstacle(QString::fromStdString(problems.front().sentence));
        return;
    }
    // A change is told from the same grid: the case itself comes first.
    if (coarseReference_) {
        follower_->follow(preview);
        return;
    }
    preview_ = std::move(preview);
    if (!follower_->busy()) follower_->follow(edited_);
}

void FilmWindow::updateInfluence()
{
    influence_.stop();
    influenceTimer_.stop();
    if (view_->shape()->showsInfluence()) influenceTimer_.start(restTime);
}

void FilmWindow::onFollowed(const SteadyResult& result)
{
    if (!coarseReference_) {
        coarseReference_ = result;
        if (auto next = std::exchange(preview_, std::nullopt)) follower_->follow(*next);
        return;
    }
    SteadyResult shown = result;
    shown.discretisationError = coarseReference_->discretisationError;
    view_->shape()->showFlight(shown, coarseReference_, true);
}

void FilmWindow::onSurfaceEdited(const AirBearingSurface& surface, const QString& text, int merge)
{
    if (result_ && !stale_) reference_ = result_;
    emit surfaceEdited(surface, text, merge);
    if (view_->shape()->follows()) restTimer_.start(restTime);
}

void FilmWindow::followEdit()
{
    if (result_ && !stale_) return; // undone meanwhile
    if (controller_.active() || follower_->busy()) {
        restTimer_.start(restTime);
        return;
    }
    if (const auto problems = checkCombinations(edited_); !problems.empty())
        view_->shape()->showObstacle(sentence(problems.front().message));
    else
        solve(edited_, false);
}

void FilmWindow::updateStale()
{
    if (!result_) return;
    stale_ = !sameFilm(edited_, solved_);
    view_->setStale(stale_);
    view_->shape()->setStale(stale_);
    attitude_->setStale(stale_);
}

} // namespace touchdown
