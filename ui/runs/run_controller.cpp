// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_controller.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QEvent>

#include "ui/runs/run_worker.h"

namespace touchdown {

namespace {

constexpr int shortestInterval = 16; // [ms]: at most 60 Hz
constexpr auto mailEvent = QEvent::User;

} // namespace

RunController::RunController(QObject* parent)
    : RunController([](const Case& c, const RunCallback& callback) { return run(c, callback); }, parent)
{}

RunController::RunController(Solver solver, QObject* parent) : QObject(parent), solver_(std::move(solver))
{
    timer_.setSingleShot(true);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &RunController::deliver);
}

RunController::~RunController() = default;

void RunController::stopAndWait()
{
    if (!worker_) return;
    worker_->stop();
    worker_->join();
    deliver();
}

int RunController::start(RunRequest request)
{
    stopAndWait();
    ++run_;
    setState(State::Running);
    emit started(run_);
    sinceDelivery_.invalidate();
    // Only the news that there is mail goes through Qt's queue; the mail itself, under the worker's mutex.
    worker_ = std::make_unique<Worker>(solver_, std::move(request), pace_,
                                       [this] { QCoreApplication::postEvent(this, new QEvent(mailEvent)); });
    return run_;
}

void RunController::pause()
{
    if (state_ != State::Running) return;
    worker_->setPaused(true);
    setState(State::Paused);
}

void RunController::resume()
{
    if (state_ != State::Paused) return;
    worker_->setPaused(false);
    setState(State::Running);
}

void RunController::step()
{
    if (state_ == State::Paused) worker_->step();
}

void RunController::stop()
{
    if (!worker_ || state_ == State::Stopping) return;
    worker_->stop();
    setState(State::Stopping);
}

void RunController::setPace(double simulatedPerWallSecond)
{
    pace_ = simulatedPerWallSecond;
    if (worker_) worker_->setPace(pace_);
}

void RunController::customEvent(QEvent* event)
{
    // News of a run before this one is harmless: a delivery takes what there is of this one.
    if (event->type() != mailEvent || !worker_ || timer_.isActive()) return;
    const qint64 passed = sinceDelivery_.isValid() ? sinceDelivery_.elapsed() : interval_;
    timer_.start(static_cast<int>(std::max<qint64>(0, interval_ - passed)));
}

void RunController::deliver()
{
    if (!worker_) return;
    timer_.stop();
    sinceDelivery_.start();

    Worker::Mail mail = worker_->take();
    mail.delivery.run = run_;
    if (!mail.recordingProblem.empty()) emit recordingFailed(run_, QString::fromStdString(mail.recordingProblem));
    emit delivered(mail.delivery);
    // A solver that waits for room is relieved at once: the plots draw at a pace of their own.
    interval_ = mail.wasFull ? 0 : shortestInterval;

    if (!mail.summary) return;
    worker_.reset();
    setState(State::Idle);
    emit finished(run_, *mail.summary);
}

void RunController::setState(State state)
{
    if (state == state_) return;
    state_ = state;
    emit stateChanged(state);
}

} // namespace touchdown
