// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/film_window.h"

#include <exception>
#include <utility>

#include "core/simulation/static_state/steady_quantities.h"
#include "ui/calculation/progress_strip.h"
#include "ui/film/film_view.h"
#include "ui/slider/attitude_sections.h"
#include "ui/slider/attitude_table.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

/// Nothing that a static solution depends on differs.
bool sameFilm(const Case& a, Case b)
{
    b.title = a.title;
    b.about = a.about;
    b.folder = a.folder;
    return a == b;
}

} // namespace

SteadyController::SteadyController(Solver solver, QObject* parent)
    : CalculationController(parent), solver_(std::move(solver))
{}

int SteadyController::start(Case c)
{
    return begin([this, c = std::move(c)](const std::stop_token& stop) {
        SteadyResult result;
        try {
            result = solver_(c, [&](const SteadyProgress& progress) {
                mailbox_.post([&](Mail& mail) { mail.progress = progress; });
                return !stop.stop_requested();
            });
        } catch (const std::exception& problem) {
            result = {};
            result.message = std::string("The calculation stopped with an error: ") + problem.what();
        }
        mailbox_.post([&](Mail& mail) { mail.result = std::move(result); });
    });
}

void SteadyController::deliver()
{
    const Mail mail = mailbox_.take();
    if (mail.progress) emit progressed(current(), progressOf(*mail.progress));
    if (!mail.result) return;
    end();
    emit finished(current(), *mail.result);
}

FilmWindow::FilmWindow(SteadyController::Solver solver, QAction* solve, QWidget* parent)
    : QObject(parent),
      controller_(std::move(solver)),
      view_(new FilmView(solve, parent)),
      attitude_(new AttitudeTable(parent)),
      progress_(new ProgressStrip(controller_, tr("static solution"), tr("Solving"), parent))
{
    connect(&controller_, &SteadyController::stateChanged, view_,
            [this](SteadyController::State state) { view_->setSolving(state != SteadyController::State::Idle); });
    connect(&controller_, &SteadyController::finished, this,
            [this](int, const SteadyResult& result) { onFinished(result); });
}

void FilmWindow::open(const Case& c)
{
    controller_.stopAndWait();
    result_.reset();
    stale_ = false;
    view_->clearResult();
    attitude_->clear();
    edited_ = c;
    view_->setCase(c);
    view_->fit();
}

void FilmWindow::edit(const Case& c)
{
    edited_ = c;
    view_->setCase(c);
    updateStale();
}

void FilmWindow::solve(const Case& c, bool given)
{
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
        updateStale();
    }
    emit solved(result);
}

void FilmWindow::updateStale()
{
    if (!result_) return;
    stale_ = !sameFilm(edited_, solved_);
    view_->setStale(stale_);
    attitude_->setStale(stale_);
}

} // namespace touchdown
