// SPDX-License-Identifier: GPL-3.0-or-later
//
// The owner of the thread of a calculation: one calculation at a time beside the window. Derived classes state what is
// calculated and what its results are.
//
// Results cross the thread border by value, in a Mailbox: the worker changes the mail under a mutex, and one event asks
// the window to take it, at most 60 times a second. Nothing that the worker posts before it ends is lost. A calculation
// that is asked to stop ends at its next callback.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/simulation/recording/progress.h"

namespace touchdown {

class CalculationController : public QObject {
    Q_OBJECT

public:
    enum class State { Idle, Running, Paused, Stopping };
    Q_ENUM(State)

    /// Stops the active calculation, if there is one, and waits for its `finished`.
    void stopAndWait();

    State state() const { return state_; }
    bool active() const { return state_ != State::Idle; }
    /// Number of the active or the last calculation, from 1.
    int current() const { return number_; }

public slots:
    /// Returns at once; `finished` follows after the next callback.
    void stop();

signals:
    void stateChanged(touchdown::CalculationController::State state);
    void progressed(int number, const touchdown::Progress& progress);

protected:
    using Work = std::function<void(const std::stop_token&)>;

    explicit CalculationController(QObject* parent);
    /// The derived class must have called `giveUp`: the thread uses its members.
    ~CalculationController() override;

    /// Starts `work` on a thread and returns the number of the calculation. An active calculation is stopped first and
    /// ends with its `finished`.
    int begin(Work work);
    /// Takes the mail and emits it; calls `end` before it emits the result.
    virtual void deliver() = 0;
    /// Joins the thread; the state is Idle afterwards.
    void end();
    /// Before `end`: whether the calculation was asked to stop.
    bool askedToStop() const { return thread_.get_stop_token().stop_requested(); }
    /// Stops and joins without a signal.
    void giveUp();
    /// Between Running and Paused; no effect in the other states, then false.
    bool setPaused(bool paused);
    /// Shortest time between two deliveries [ms].
    void setInterval(int interval) { interval_ = interval; }

    static constexpr int shortestInterval = 16; // [ms]: 60 Hz

    void customEvent(QEvent* event) override;

private:
    template <class Mail>
    friend class Mailbox;

    void ring();
    void deliverNow();
    void setState(State state);

    QTimer timer_;
    QElapsedTimer sinceDelivery_;
    int interval_ = shortestInterval;
    State state_ = State::Idle;
    int number_ = 0;
    std::atomic<bool> rung_ = false; // an event is on its way
    std::jthread thread_;
};

/// Mail from the worker's thread to the window. The newest progress replaces the one before it; samples are appended.
template <class Mail>
class Mailbox {
public:
    explicit Mailbox(CalculationController& reader) : reader_(reader) {}

    /// On the worker's thread: changes the mail and notifies the window.
    template <class Change>
    void post(const Change& change)
    {
        {
            const std::lock_guard lock(mutex_);
            change(mail_);
        }
        reader_.ring();
    }

    /// On the worker's thread: waits until `room(mail)` is true or a stop is requested.
    template <class Room>
    void waitForRoom(const std::stop_token& stop, const Room& room)
    {
        std::unique_lock lock(mutex_);
        taken_.wait(lock, stop, [&] { return room(mail_); });
    }

    /// On the window's thread.
    Mail take()
    {
        const std::lock_guard lock(mutex_);
        taken_.notify_all();
        return std::exchange(mail_, {});
    }

private:
    CalculationController& reader_;
    std::mutex mutex_;
    std::condition_variable_any taken_;
    Mail mail_;
};

} // namespace touchdown
