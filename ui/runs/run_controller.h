// SPDX-License-Identifier: GPL-3.0-or-later
//
// The only owner of a thread: runs one case at a time beside the window.
//
// The solver's batches cross the thread border by value and lose nothing: the worker appends them to
// a mailbox under a mutex, and asks for one queued call if none is pending; the window swaps the
// mailbox empty at most 60 times a second, or as often as it can while a fast solver waits for room in
// it. The mailbox is bounded, so that a delivery is short and the window goes on answering. Every
// delivery carries the number of its run, so that one that comes late is dropped.
//
// Slow motion and pause hold back samples, not the solver's arithmetic: the worker hands out a batch
// slice by slice, and waits on a condition variable in between.
#pragma once

#include "core/simulation/run.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>

#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace touchdown {

/// What is to be run.
struct RunRequest {
    Case value;
    std::string caseText;           // the exact input, for the results file
    std::filesystem::path recordTo; // a results file written while the run goes; empty for none
};

/// What has arrived since the last delivery.
struct RunDelivery {
    int run = 0; // number of the run
    SampleBatch samples;
    std::vector<RunEvent> events;
    std::vector<FieldSnapshot> fields; // of recordedFields()
    double time = 0.0;                 // reached [s]
    double duration = 0.0;             // of the whole run [s]
};

class RunController : public QObject {
    Q_OBJECT

public:
    enum class State { Idle, Running, Paused, Stopping };
    Q_ENUM(State)

    using Solver = std::function<Summary(const Case&, const RunCallback&)>;
    static constexpr double fullSpeed = std::numeric_limits<double>::infinity();

    explicit RunController(QObject* parent = nullptr);
    /// With another solver than `touchdown::run`.
    explicit RunController(Solver solver, QObject* parent = nullptr);
    /// Stops and joins.
    ~RunController() override;

    /// Starts a run and returns its number. A run that is under way is stopped first, and ends with its `finished`.
    int start(RunRequest request);

    /// Ends the run under way, if there is one, with its `finished`.
    void stopAndWait();

    State state() const { return state_; }
    bool active() const { return state_ != State::Idle; }
    int currentRun() const { return run_; }
    double pace() const { return pace_; }

public slots:
    void pause();
    void resume();
    /// Lets a paused run go on by one picture: 1/60 s of its pace, or 1/200 of its duration at full speed.
    void step();
    /// Returns at once; `finished` follows within 0.1 s.
    void stop();
    /// Simulated seconds per second of wall time; takes effect at once.
    void setPace(double simulatedPerWallSecond);

signals:
    void stateChanged(touchdown::RunController::State state);
    void started(int run);
    void delivered(const touchdown::RunDelivery& delivery);
    void finished(int run, const touchdown::Summary& summary);
    /// The results file could not be written; the run goes on without it.
    void recordingFailed(int run, const QString& problem);

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
    int interval_ = 16; // between deliveries [ms]
    State state_ = State::Idle;
    int run_ = 0;
    double pace_ = fullSpeed; // [s/s]
};

} // namespace touchdown
