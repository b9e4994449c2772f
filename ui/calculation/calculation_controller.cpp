// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calculation/calculation_controller.h"

#include <algorithm>
#include <memory>

#include <QCoreApplication>
#include <QEvent>

#include "core/work/team.h"

namespace touchdown {

namespace {

constexpr auto mailEvent = QEvent::User;

} // namespace

CalculationController::CalculationController(QObject* parent) : QObject(parent)
{
    timer_.setSingleShot(true);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &CalculationController::deliverNow);
}

CalculationController::~CalculationController() { Q_ASSERT(!thread_.joinable()); }

int CalculationController::begin(Work work)
{
    stopAndWait();
    ++number_;
    setState(State::Running);
    sinceDelivery_.invalidate();
    rung_ = false;
    thread_ = std::jthread([work = std::move(work)](const std::stop_token& stop) {
        // One core is left to the window; calculations that begin beside others share the rest.
        static std::atomic<int> underWay = 0;
        const int calculations = ++underWay, cores = threadShare();
        const std::shared_ptr<void> end(nullptr, [](void*) { --underWay; });
        setThreadShare(std::max(1, (cores > 2 ? cores - 1 : cores) / calculations));
        work(stop);
    });
    return number_;
}

void CalculationController::ring()
{
    // One event until the window takes the mail.
    if (!rung_.exchange(true)) QCoreApplication::postEvent(this, new QEvent(mailEvent));
}

void CalculationController::stop()
{
    if (!active() || state_ == State::Stopping) return;
    thread_.request_stop();
    setState(State::Stopping);
}

void CalculationController::stopAndWait()
{
    if (!active()) return;
    thread_.request_stop();
    thread_.join();
    deliverNow();
}

void CalculationController::end()
{
    if (thread_.joinable()) thread_.join();
    setState(State::Idle);
}

void CalculationController::giveUp()
{
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
}

bool CalculationController::setPaused(bool paused)
{
    if (state_ != (paused ? State::Running : State::Paused)) return false;
    setState(paused ? State::Paused : State::Running);
    return true;
}

void CalculationController::customEvent(QEvent* event)
{
    // An event of an earlier calculation is harmless: the mailbox holds the mail of this one only.
    if (event->type() != mailEvent || !active() || timer_.isActive()) return;
    const qint64 passed = sinceDelivery_.isValid() ? sinceDelivery_.elapsed() : interval_;
    timer_.start(static_cast<int>(std::max<qint64>(0, interval_ - passed)));
}

void CalculationController::deliverNow()
{
    if (!active()) return;
    timer_.stop();
    sinceDelivery_.start();
    rung_ = false; // before the mail is taken: later mail posts a new event
    deliver();
}

void CalculationController::setState(State state)
{
    if (state == state_) return;
    state_ = state;
    emit stateChanged(state);
}

} // namespace touchdown
