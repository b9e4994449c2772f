// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solves one case for its static state at a time, beside the window.
//
// The worker's news cross the thread border by value: the latest progress under a mutex, taken by the window at most 60
// times a second, and at the end the whole result. A solution that is stopped ends at the solver's next callback.
#pragma once

#include <functional>
#include <memory>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/simulation/steady.h"

namespace touchdown {

class SteadyController : public QObject {
    Q_OBJECT

public:
    enum class State { Idle, Running, Stopping };
    Q_ENUM(State)

    using Solver = std::function<SteadyResult(const Case&, const SteadyCallback&)>;

    /// `solver` is `touchdown::steady`, or what stands for it in a test.
    explicit SteadyController(Solver solver, QObject* parent = nullptr);
    /// Stops and joins.
    ~SteadyController() override;

    /// Starts and returns the number of the solution. One that is under way is stopped first, and ends with its `finished`.
    int start(Case c);
    /// Ends the solution under way, if there is one, with its `finished`.
    void stopAndWait();

    State state() const { return state_; }
    bool active() const { return state_ != State::Idle; }
    int current() const { return number_; }

public slots:
    /// Returns at once; `finished` follows after the solver's next callback.
    void stop();

signals:
    void stateChanged(touchdown::SteadyController::State state);
    void progressed(int number, const touchdown::SteadyProgress& progress);
    void finished(int number, const touchdown::SteadyResult& result);

protected:
    void customEvent(QEvent* event) override;

private:
    class Worker;

    void deliver();
    void setState(State state);

    Solver solver_;
    std::unique_ptr<Worker> worker_;
    QTimer timer_;
    QElapsedTimer sinceDelivery_;
    State state_ = State::Idle;
    int number_ = 0;
};

} // namespace touchdown
