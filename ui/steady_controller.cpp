// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/steady_controller.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <QCoreApplication>
#include <QEvent>

namespace touchdown {

namespace {

constexpr int shortestInterval = 16; // [ms]: at most 60 Hz
constexpr auto mailEvent = QEvent::User;

} // namespace

/// The other side of the thread border.
class SteadyController::Worker {
public:
    struct Mail {
        std::optional<SteadyProgress> progress; // the latest
        std::optional<SteadyResult> result;
    };

    /// `notify` is called on the worker's thread, once until the next `take`.
    Worker(const Solver& solver, Case c, std::function<void()> notify)
        : notify_(std::move(notify)),
          thread_([this, solver, c = std::move(c)](const std::stop_token& stop) { work(solver, c, stop); })
    {
    }

    void stop() { thread_.request_stop(); }
    void join()
    {
        if (thread_.joinable()) thread_.join();
    }

    Mail take()
    {
        const std::lock_guard lock(mutex_);
        rung_ = false;
        return std::exchange(mail_, {});
    }

private:
    void work(const Solver& solver, const Case& c, const std::stop_token& stop)
    {
        SteadyResult result;
        try {
            result = solver(c, [&](const SteadyProgress& progress) {
                post([&](Mail& mail) { mail.progress = progress; });
                return !stop.stop_requested();
            });
        } catch (const std::exception& problem) {
            result = {};
            result.message = std::string("The calculation broke off: ") + problem.what();
        }
        post([&](Mail& mail) { mail.result = std::move(result); });
    }

    template <typename Change>
    void post(const Change& change)
    {
        {
            const std::lock_guard lock(mutex_);
            change(mail_);
            if (std::exchange(rung_, true)) return;
        }
        notify_();
    }

    std::function<void()> notify_;
    std::mutex mutex_;
    Mail mail_;
    bool rung_ = false;
    std::jthread thread_; // last, so that it starts after, and ends before, all that it uses
};

SteadyController::SteadyController(Solver solver, QObject* parent) : QObject(parent), solver_(std::move(solver))
{
    timer_.setSingleShot(true);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &SteadyController::deliver);
}

SteadyController::~SteadyController() = default;

int SteadyController::start(Case c)
{
    stopAndWait();
    ++number_;
    setState(State::Running);
    sinceDelivery_.invalidate();
    worker_ = std::make_unique<Worker>(solver_, std::move(c),
                                       [this] { QCoreApplication::postEvent(this, new QEvent(mailEvent)); });
    return number_;
}

void SteadyController::stop()
{
    if (state_ != State::Running) return;
    worker_->stop();
    setState(State::Stopping);
}

void SteadyController::stopAndWait()
{
    if (!worker_) return;
    worker_->stop();
    worker_->join();
    deliver();
}

void SteadyController::customEvent(QEvent* event)
{
    // News of a solution before this one is harmless: a delivery takes what there is of this one.
    if (event->type() != mailEvent || !worker_ || timer_.isActive()) return;
    const qint64 passed = sinceDelivery_.isValid() ? sinceDelivery_.elapsed() : shortestInterval;
    timer_.start(static_cast<int>(std::max<qint64>(0, shortestInterval - passed)));
}

void SteadyController::deliver()
{
    if (!worker_) return;
    timer_.stop();
    sinceDelivery_.start();
    Worker::Mail mail = worker_->take();
    if (mail.progress) emit progressed(number_, *mail.progress);
    if (!mail.result) return;
    worker_.reset();
    setState(State::Idle);
    emit finished(number_, *mail.result);
}

void SteadyController::setState(State state)
{
    if (state == state_) return;
    state_ = state;
    emit stateChanged(state);
}

} // namespace touchdown
