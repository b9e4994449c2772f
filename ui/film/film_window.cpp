// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/film_window.h"

#include <algorithm>
#include <utility>

#include "core/case/parameters.h"
#include "core/physics/slider/lift_area.h"
#include "core/physics/slider/surface_check.h"
#include "core/simulation/static_state/static_solution.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "ui/calculation/progress_strip.h"
#include "ui/film/film_view.h"
#include "ui/film/series_page.h"
#include "ui/film/surface_page.h"
#include "ui/lists/record_panel.h"
#include "ui/slider/attitude_sections.h"
#include "ui/slider/attitude_table.h"
#include "ui/style/quantity_format.h"
#include "ui/style/window_words.h"

namespace touchdown {

namespace {

constexpr std::size_t mostFruitless = 16; // searches that are remembered
constexpr int restTime = 250;             // after the last edit of the shape [ms]

/// A baseline of another slider says nothing about an edit of this one.
bool ofTheSameSize(const Case& a, const Case& b)
{
    return a.slider.length == b.slider.length && a.slider.width == b.slider.width;
}

} // namespace

FilmWindow::FilmWindow(SteadyController::Solver solver, QAction* solve, QWidget* parent, ShapeFollower::Solver near)
    : QObject(parent),
      controller_(std::move(solver)),
      view_(new FilmView(solve, parent)),
      panel_(new RecordPanel(solutions_, RecordPanel::wordsOfSolutions(), parent)),
      attitude_(new AttitudeTable(parent)),
      progress_(new ProgressStrip(controller_, tr("static solution"), tr("Solving"), parent)),
      follower_(new ShapeFollower(std::move(near), this))
{
    connect(&controller_, &SteadyController::stateChanged, view_,
            [this](SteadyController::State state) { view_->setSolving(state != SteadyController::State::Idle); });
    connect(&controller_, &SteadyController::finished, this,
            [this](int, const SteadyResult& result) { onFinished(result); });
    connect(panel_, &RecordPanel::recordChosen, this, &FilmWindow::show);
    connect(&solutions_, &RecordList::shownChanged, this, &FilmWindow::showComparison);
    connect(&solutions_, &RecordList::baselineChanged, this, &FilmWindow::showComparison);
    connect(&solutions_, &RecordList::rowsRemoved, this, &FilmWindow::showComparison);
    connect(view_->series(), &SeriesPage::solved, this, [this](const Case& c, const SteadyResult& result) {
        if (!result.pressure.empty()) solutions_.add(c, result, {}, false);
    });
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

FilmWindow::~FilmWindow()
{
    solutions_.disconnect();
    controller_.disconnect();
}

const SteadyResult* FilmWindow::result() const
{
    const SolutionRecord* record = shown();
    return record ? &record->result : nullptr;
}

void FilmWindow::open(const Case& c)
{
    controller_.stopAndWait();
    forgetPreviews();
    restTimer_.stop();
    before_ = -1;
    beforeOf_.clear();
    edited_ = c;
    solutions_.setOpened(c);
    view_->open(c);
    view_->shape()->open(c);
    emit view_->shape()->influenceWanted();
    const SolutionRecord* known = knownOf(c);
    show(known ? known->number : -1);
    panel_->choose(shown_);
    view_->fit();
}

void FilmWindow::show(int number)
{
    shown_ = number;
    const SolutionRecord* record = shown();
    if (record) {
        view_->setResult(record->value, record->result);
        attitude_->setResult(record->value, record->result);
    } else {
        view_->clearResult();
        attitude_->clear();
    }
    updateStale();
    showComparison();
    showOutcome();
    emit shownChanged();
}

void FilmWindow::showComparison()
{
    view_->compare(shown(), solutions_.compared(), solutions_.baseline());
    showFlight();
}

void FilmWindow::showFlight()
{
    SurfacePage* shape = view_->shape();
    const SolutionRecord* record = shown();
    if (!record) {
        shape->clearFlight();
    } else if (stale_ && record->result.status != SteadyStatus::Converged) {
        shape->showConfirmed(); // why another shape does not fly says nothing about this one
    } else {
        shape->showFlight(record->result, reference(), false);
        shape->setStale(stale_);
    }
    if (const auto problems = surfaceProblems(edited_.surface); !problems.empty())
        shape->showObstacle(QString::fromStdString(problems.front().sentence));
}

void FilmWindow::showOutcome()
{
    if (controller_.active()) return;
    if (shown() && !stale_)
        conclude(shown()->result);
    else
        progress_->clear();
}

const SolutionRecord* FilmWindow::knownOf(const Case& c) const
{
    const SolutionRecord* found = solutions_.of(c);
    return found ? found : solutions_.failureOf(c);
}

std::optional<SteadyResult> FilmWindow::reference() const
{
    const auto before = beforeOf_.find(shown_);
    for (const int number : {solutions_.baseline(), before == beforeOf_.end() ? -1 : before->second})
        if (const SolutionRecord* record = solutions_.find(number);
            record && number != shown_ && ofTheSameSize(record->value, edited_))
            return record->result;
    return std::nullopt;
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
    const bool wasStale = stale_;
    const int last = shown() && !stale_ ? shown_ : -1;
    if (edited_ != c) forgetPreviews();
    edited_ = c;
    view_->setCase(c);
    emit view_->shape()->influenceWanted();
    // Undo and redo are followed, too.
    updateStale();
    const SolutionRecord* known = stale_ || !shown() ? knownOf(c) : nullptr;
    if (known)
        before_ = beforeOf_.contains(known->number) ? beforeOf_[known->number] : -1;
    else if (shaped && stale_ && last >= 0)
        before_ = last;
    if ((known || (shown() && !stale_)) && controller_.active() && !isEdited(asked_, {}))
        controller_.stop(); // of a case that was left for one that is solved
    if (known) {
        restTimer_.stop();
        solutions_.compareByItself(known->number);
        panel_->choose(known->number);
    } else if (shaped && shown_ >= 0 && view_->shape()->follows()) {
        restTimer_.start(restTime);
    }
    // What kept the last shape from flying is gone, as after undo.
    if (shown() && !stale_)
        showFlight();
    else if (checkCombinations(edited_).empty())
        view_->shape()->clearObstacle();
    showOutcome();
    if (stale_ != wasStale) emit shownChanged();
}

void FilmWindow::solve(const Case& c, bool given)
{
    byItself_ = false;
    restTimer_.stop();
    controller_.stopAndWait();
    asked_ = c;
    asked_.steady.fixedAttitude = asked_.steady.fixedAttitude || given;
    controller_.start(asked_);
}

void FilmWindow::conclude(const SteadyResult& result)
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
}

void FilmWindow::onFinished(const SteadyResult& result)
{
    conclude(result);
    // A shape that is being drawn passes through many that do not fly: nobody asked for them.
    if (byItself_ && (result.status == SteadyStatus::NotConverged || result.status == SteadyStatus::Failed)) {
        if (fruitless_.size() == mostFruitless) fruitless_.erase(fruitless_.begin());
        fruitless_.push_back({asked_, result});
        fruitless_.back().state.dropFields();
        if (isEdited(asked_, {})) view_->shape()->showObstacle(reasonToWait());
        return;
    }
    // A solution that ended without a field does not replace the last one.
    if (!result.pressure.empty() && result.status != SteadyStatus::Cancelled) {
        beforeOf_[solutions_.nextNumber()] = before_;
        solutions_.add(asked_, result); // which chooses it
    } else if (!shown())
        attitude_->setResult(asked_, result);
    emit solved(result);
}

void FilmWindow::onPreviewed(const AirBearingSurface& surface)
{
    const bool follows = view_->shape()->follows();
    if (surface == edited_.surface && !view_->shape()->editor()->dragging()) {
        // A gesture that is given up, or ends where it began, has stopped what was being solved.
        preview_.reset();
        follower_->forget();
        showFlight();
        if (stale_ && follows) restTimer_.start(restTime);
        return;
    }
    if (!follows) return;
    if (view_->shape()->editor()->dragging()) controller_.stop();
    restTimer_.stop();
    if (const auto problems = surfaceProblems(surface); !problems.empty()) {
        preview_.reset();
        follower_->forget(); // what it finds now is of another shape
        view_->shape()->showObstacle(QString::fromStdString(problems.front().sentence));
        return;
    }
    Case preview = edited_;
    preview.surface = surface;
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
    emit surfaceEdited(surface, text, merge);
    if (view_->shape()->follows()) restTimer_.start(restTime);
}

void FilmWindow::followEdit()
{
    if (shown() && !stale_) return; // undone meanwhile
    if (controller_.active() || follower_->busy()) {
        restTimer_.start(restTime);
        return;
    }
    const auto problems = checkCombinations(edited_);
    const QString reason = problems.empty() ? reasonToWait() : sentence(problems.front().message);
    if (!reason.isEmpty()) return view_->shape()->showObstacle(reason);
    solve(edited_, false);
    byItself_ = true;
}

QString FilmWindow::reasonToWait() const
{
    const auto found =
        std::ranges::find_if(fruitless_, [this](const StaticSolution& each) { return isEdited(each.solved, {}); });
    if (found != fruitless_.end()) return tr("It does not fly so: %1").arg(inWindowWords(found->state.message));
    const SurfacePoint load{0.5 * edited_.slider.length + edited_.suspension.offsetX,
                            0.5 * edited_.slider.width + edited_.suspension.offsetY};
    const SuspensionCase& suspension = edited_.suspension;
    const bool turned = suspension.holdsAttitude || suspension.pitchTorque != 0.0 || suspension.rollTorque != 0.0;
    const bool rollHeld = edited_.degreesOfFreedom == 2;
    if (edited_.steady.fixedAttitude || turned || railsSurround(edited_.surface, load, rollHeld)) return {};
    return tr("Not solved: the rails do not surround the place where the suspension presses. F9 solves all the same.");
}

bool FilmWindow::isEdited(Case solved, const Attitude& found) const
{
    // A solution at a given attitude is one of the case as it is, though that does not hold the attitude.
    solved.steady.fixedAttitude = edited_.steady.fixedAttitude;
    return hasStaticState(edited_, solved, found);
}

void FilmWindow::updateStale()
{
    const SolutionRecord* record = shown();
    // A search from where another one gave up may find a state.
    const bool found = record && record->result.status == SteadyStatus::Converged;
    stale_ = record && !isEdited(record->value, found ? record->result.attitude : Attitude{});
    view_->setStale(stale_);
    view_->shape()->setStale(stale_);
    attitude_->setStale(stale_);
}

} // namespace touchdown
