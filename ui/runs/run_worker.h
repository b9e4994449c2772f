// SPDX-License-Identifier: GPL-3.0-or-later
//
// The other side of the thread border: one run on its own thread, what it is told, and what it has
// to tell. Owned by RunController.
#pragma once

#include "ui/runs/run_controller.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <thread>

namespace touchdown {

class RunController::Worker {
public:
    /// `notify` is called on the worker's thread, once until the next `take`.
    Worker(Solver solver, RunRequest request, double pace, std::function<void()> notify);
    /// Stops and joins.
    ~Worker();

    struct Mail {
        RunDelivery delivery;
        std::optional<Summary> summary;
        std::string recordingProblem;
        bool wasFull = false; // the worker had to wait for room
    };
    /// All that has come since the last call.
    Mail take();

    void setPaused(bool paused);
    void step();
    void stop();
    void setPace(double pace);
    /// Waits for the end of the thread.
    void join();

private:
    using Clock = std::chrono::steady_clock;

    void work();
    bool handOut(const RunUpdate& update);
    std::optional<std::size_t> waitForSlice(const SampleBatch& batch, std::size_t begin, double duration);
    bool waitWhilePaused();
    bool stopRequested();
    void waitForRoom(std::size_t samples, std::size_t fieldValues);
    /// What of an update is handed out together.
    struct Slice {
        std::size_t begin = 0, end = 0; // of the samples
        std::span<const RunEvent> events;
        std::span<const FieldSnapshot> fields;
    };
    void post(const RunUpdate& update, const Slice& slice);
    void record(const SampleBatch& samples, std::span<const FieldSnapshot> fields);
    void ring();
    Summary shownSummary(Summary summary) const;

    Solver solver_;
    RunRequest request_;
    std::function<void()> notify_;

    // Told by the window.
    std::mutex orders_;
    std::condition_variable ordered_;
    std::atomic<bool> stopped_ = false;
    bool paused_ = false;
    int steps_ = 0;
    double pace_; // [s/s]
    bool paceAnchored_ = false;

    // The worker's own.
    Clock::time_point wallAnchor_;
    double timeAnchor_ = 0.0; // [s]
    double shownTime_ = 0.0;  // of the last sample handed out [s]
    double stepUntil_ = 0.0;  // [s]
    bool heldBack_ = false;   // stopped with samples that nobody saw
    std::vector<double> lastSample_;
    struct Recorder;
    std::unique_ptr<Recorder> recorder_;

    // Told to the window.
    std::mutex mailbox_;
    std::condition_variable emptied_;
    Mail mail_;
    std::atomic<bool> pending_ = false;

    std::jthread thread_; // last, so that it starts after, and ends before, all that it uses
};

} // namespace touchdown
