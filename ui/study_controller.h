// SPDX-License-Identifier: GPL-3.0-or-later
//
// Performs one study at a time, beside the window.
//
// Progress and partial reports cross the thread border by value: the latest of each under a mutex, taken by the window at most 60
// times a second, and at the end the whole report. A study that is stopped ends at its next callback, within 50 ms.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/studies/study.h"

namespace touchdown {

class StudyController : public QObject {
    Q_OBJECT

public:
    enum class State { Idle, Running, Stopping };
    Q_ENUM(State)

    explicit StudyController(QObject* parent = nullptr);
    /// Stops and joins.
    ~StudyController() override;

    /// Starts on up to `jobs` threads and returns the number of the study. One that is under way is stopped first, and ends with its
    /// `finished`.
    int start(StudyPerformance perform, int jobs);
    /// Ends the study under way, if there is one, with its `finished`.
    void stopAndWait();

    State state() const { return state_; }
    bool active() const { return state_ != State::Idle; }
    int current() const { return number_; }

public slots:
    /// Returns at once; `finished` follows after the study's next callback.
    void stop();

signals:
    void stateChanged(touchdown::StudyController::State state);
    void progressed(int number, double share, const QString& doing);
    /// There is more to show than before.
    void partial(int number, const touchdown::StudyReport& report);
    void finished(int number, const touchdown::StudyReport& report);

protected:
    void customEvent(QEvent* event) override;

private:
    class Worker;

    void deliver();
    void setState(State state);

    std::unique_ptr<Worker> worker_;
    QTimer timer_;
    QElapsedTimer sinceDelivery_;
    State state_ = State::Idle;
    int number_ = 0;
};

} // namespace touchdown
