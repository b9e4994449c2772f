// SPDX-License-Identifier: GPL-3.0-or-later
//
// Performs tasks on a thread of its own, in the order in which the window asks, so that neither the window nor a solver
// waits for the disk or for a long calculation.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include <QObject>
#include <QString>

namespace touchdown {

class TaskQueue : public QObject {
public:
    using Task = std::function<QString()>;                    // returns "" or the problem in a sentence
    using Then = std::function<void(const QString& problem)>; // on the thread of the window

    explicit TaskQueue(QObject* parent);
    /// Performs what was asked for; calls no `Then` any more.
    ~TaskQueue() override;

    /// `bytes`: of memory that the task holds until it is done.
    void post(Task task, Then then = {}, std::size_t bytes = 0);
    /// Bytes of all tasks that are not done.
    std::size_t pending() const;
    /// Until all that was asked for is done; the calls of `Then` follow as events.
    void wait();

private:
    struct Entry {
        Task task;
        Then then;
        std::size_t bytes = 0;
    };
    void work(const std::stop_token& stop);

    mutable std::mutex mutex_; // of all below
    std::condition_variable_any changed_;
    std::deque<Entry> entries_; // the first is being performed
    std::size_t bytes_ = 0;
    std::jthread thread_; // last: its end comes before that of what it uses
};

} // namespace touchdown
