// SPDX-License-Identifier: GPL-3.0-or-later
//
// One calculation at a time, on a thread beside the window: what is common to static solutions and studies.
//
// The worker's news cross the thread border by value: the latest of each kind under a mutex, taken by the window at
// most 60 times a second, and at the end the whole result. A calculation that is stopped ends at its next callback.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace touchdown {

/// News of a worker, until the window takes them; each kind is a std::optional in `Mail`.
template <class Mail>
class Mailbox {
public:
    template <class Change>
    void post(const Change& change)
    {
        const std::lock_guard lock(mutex_);
        change(mail_);
    }
    Mail take()
    {
        const std::lock_guard lock(mutex_);
        return std::exchange(mail_, {});
    }

private:
    std::mutex mutex_;
    Mail mail_;
};

class CalculationController : public QObject {
    Q_OBJECT

public:
    enum class State { Idle, Running, Stopping };
    Q_ENUM(State)

    /// Ends the calculation under way, if there is one, with its `finished`.
    void stopAndWait();

    State state() const { return state_; }
    bool active() const { return state_ != State::Idle; }
    int current() const { return number_; }

public slots:
    /// Returns at once; `finished` follows after the next callback.
    void stop();

signals:
    void stateChanged(touchdown::CalculationController::State state);

protected:
    using Work = std::function<void(const std::stop_token&)>;

    explicit CalculationController(QObject* parent);
    /// What is under way must have been given up: its thread uses members of a class that is gone by now.
    ~CalculationController() override;

    /// Starts on a thread of its own and returns the number of the calculation. One that is under way is stopped first,
    /// and ends with its `finished`.
    int begin(Work work);
    /// Called on the worker's thread: there is mail.
    void ring();
    /// Takes the mail and tells of it; calls `end` before it tells of the result.
    virtual void deliver() = 0;
    /// Joins the thread and is idle.
    void end();
    /// Stops and joins, and tells nobody.
    void giveUp();

    void customEvent(QEvent* event) override;

private:
    void deliverNow();
    void setState(State state);

    QTimer timer_;
    QElapsedTimer sinceDelivery_;
    State state_ = State::Idle;
    int number_ = 0;
    std::atomic<bool> rung_ = false; // an event is on its way
    std::jthread thread_;
};

} // namespace touchdown
