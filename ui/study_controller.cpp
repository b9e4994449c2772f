// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study_controller.h"

#include <algorithm>
#include <exception>
#include <mutex>
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
class StudyController::Worker {
public:
    struct Progress {
        double share = 0.0;
        std::string doing;
    };
    struct Mail {
        std::optional<Progress> progress;   // the latest
        std::optional<StudyReport> partial; // the latest
        std::optional<StudyReport> report;
    };

    /// `notify` is called on the worker's thread, once until the next `take`.
    Worker(StudyPerformance perform, int jobs, std::function<void()> notify)
        : notify_(std::move(notify)),
          thread_([this, perform = std::move(perform), jobs](const std::stop_token& stop) { work(perform, jobs, stop); })
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
    void work(const StudyPerformance& perform, int jobs, const std::stop_token& stop)
    {
        StudyReport report;
        try {
            report = perform(jobs, [&](const StudyProgress& progress) {
                Progress now{progress.share, progress.doing};
                std::optional<StudyReport> soFar; // copied before the window could be kept waiting
                if (progress.soFar) soFar = *progress.soFar;
                post([&](Mail& mail) {
                    mail.progress = std::move(now);
                    if (soFar) mail.partial = std::move(soFar);
                });
                return !stop.stop_requested();
            });
        } catch (const std::exception& problem) {
            report = {};
            report.status = StudyStatus::Failed;
            report.message = std::string("The study broke off: ") + problem.what();
        }
        post([&](Mail& mail) { mail.report = std::move(report); });
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

StudyController::StudyController(QObject* parent) : QObject(parent)
{
    timer_.setSingleShot(true);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &StudyController::deliver);
}

StudyController::~StudyController() = default;

int StudyController::start(StudyPerformance perform, int jobs)
{
    stopAndWait();
    ++number_;
    setState(State::Running);
    sinceDelivery_.invalidate();
    worker_ = std::make_unique<Worker>(std::move(perform), jobs,
                                       [this] { QCoreApplication::postEvent(this, new QEvent(mailEvent)); });
    return number_;
}

void StudyController::stop()
{
    if (state_ != State::Running) return;
    worker_->stop();
    setState(State::Stopping);
}

void StudyController::stopAndWait()
{
    if (!worker_) return;
    worker_->stop();
    worker_->join();
    deliver();
}

void StudyController::customEvent(QEvent* event)
{
    // News of a study before this one is harmless: a delivery takes what there is of this one.
    if (event->type() != mailEvent || !worker_ || timer_.isActive()) return;
    const qint64 passed = sinceDelivery_.isValid() ? sinceDelivery_.elapsed() : shortestInterval;
    timer_.start(static_cast<int>(std::max<qint64>(0, shortestInterval - passed)));
}

void StudyController::deliver()
{
    if (!worker_) return;
    timer_.stop();
    sinceDelivery_.start();
    Worker::Mail mail = worker_->take();
    if (mail.progress) emit progressed(number_, mail.progress->share, QString::fromStdString(mail.progress->doing));
    if (mail.partial && !mail.report) emit partial(number_, *mail.partial);
    if (!mail.report) return;
    worker_.reset();
    setState(State::Idle);
    emit finished(number_, *mail.report);
}

void StudyController::setState(State state)
{
    if (state == state_) return;
    state_ = state;
    emit stateChanged(state);
}

} // namespace touchdown
